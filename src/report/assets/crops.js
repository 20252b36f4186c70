// SPDX-License-Identifier: MIT
// A crop leads to its place in the comparison.
function startCrops(section) {
  for (const row of section.querySelectorAll('.croprow')) {
    const [x, y, size] = [row.dataset.x, row.dataset.y, row.dataset.size].map(Number);
    for (const figure of row.querySelectorAll('figure[data-record]')) {
      const record = Number(figure.dataset.record), [width, height] = kRecords[record].size;
      const show = () => {
        pickRun(section, record, [(x + size / 2) / width, (y + size / 2) / height, Math.min(width, height) / size]);
        section.querySelector('.compare').scrollIntoView({ block: 'nearest' });
      };
      figure.tabIndex = 0;
      figure.setAttribute('role', 'button');
      figure.addEventListener('click', show);
      figure.addEventListener('keydown', event => {
        if (event.key !== 'Enter' && event.key !== ' ') return;
        event.preventDefault();
        show();
      });
    }
  }
}
