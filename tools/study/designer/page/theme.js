// Dark for dim rooms, light for bright ones. The choice is kept in this browser, under the name that the viewer uses.
const KEPT_AS = 'telepalp-theme';

/** The browser's store; undefined where it is forbidden. */
function store() {
  try {
    return globalThis.localStorage;
  } catch {
    return undefined;
  }
}

let theme = store()?.getItem(KEPT_AS) === 'light' ? 'light' : 'dark';

function apply() {
  document.documentElement.dataset.theme = theme;
  const button = document.getElementById('theme');
  button.textContent = theme === 'light' ? 'Dark' : 'Light';
}

document.getElementById('theme').addEventListener('click', () => {
  theme = theme === 'light' ? 'dark' : 'light';
  store()?.setItem(KEPT_AS, theme);
  apply();
});
apply();
