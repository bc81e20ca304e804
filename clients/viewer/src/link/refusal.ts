/** What a refused command tells its sender; `text` is the server's reason. */
export function refusal(status: number, text: string): string {
  const reason = text.trim();
  if (status === 401) return 'Your sign-in has ended. Reload the page and sign in again.';
  if (status === 403) return `The server refused: ${reason || 'you may not do this'}.`;
  return `The command failed: ${reason || `HTTP status ${status}`}`;
}

export const GONE = 'The server does not answer. Try again when it answers.';
