// SPDX-License-Identifier: MIT
// System, light, dark, and round again.
function startTheme() {
  const themes = ['system', 'light', 'dark'];
  const toggle = document.getElementById('theme');
  let theme = 'system';
  const show = () => {
    if (theme === 'system') delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    toggle.textContent = 'Theme: ' + theme;
  };
  toggle.addEventListener('click', () => {
    theme = themes[(themes.indexOf(theme) + 1) % themes.length];
    show();
  });
}
