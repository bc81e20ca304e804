// The WebSocket to the program. The page's address has the token.

/**
 * Opens the link. `hear(message)`: each message of the program. `say(state, text)`: live, wait or lost, and why.
 * `command`: the one that serves the page. Returns `send(text)`, which does nothing while the link is closed.
 */
export function openLink(hear, say, command = 'telepalp-study designer') {
  const token = new URLSearchParams(location.search).get('token') ?? '';
  let socket;
  let tried = 0;
  const connect = () => {
    socket = new WebSocket(`ws://${location.host}/live?token=${encodeURIComponent(token)}`);
    let opened = false;
    socket.addEventListener('open', () => {
      opened = true;
      tried = 0;
      say('live', 'live');
    });
    socket.addEventListener('message', ({data}) => hear(JSON.parse(data)));
    socket.addEventListener('close', () => {
      ++tried;
      const lost = `${command} has ended, or its address is another one. Start it and open what it prints`;
      say('lost', opened || tried > 1 ? lost : `this address is not the one that ${command} printed`);
      if (opened) setTimeout(connect, 2000);
    });
  };
  if (token === '') say('lost', `open the address that ${command} printed: it ends with a token`);
  else connect();
  return (text) => {
    if (socket?.readyState === WebSocket.OPEN) socket.send(text);
  };
}
