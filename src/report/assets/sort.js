// SPDX-License-Identifier: MIT
// A heading's button sorts by its column; what was not measured stays last. A second press turns the order.
function startSorting(table) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const press = head.querySelector('button');
    if (!press) return;
    press.addEventListener('click', () => {
      const down = head.getAttribute('aria-sort') === 'ascending';
      heads.forEach(other => other.removeAttribute('aria-sort'));
      head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
      const numeric = head.dataset.kind === 'number';
      const value = row => row.cells[column].dataset.v ?? row.cells[column].textContent;
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => {
        const x = value(a), y = value(b);
        if (numeric && (x === '' || y === '')) return (x === '') - (y === '');
        const order = numeric ? Number(x) - Number(y) : x.localeCompare(y, 'en');
        return down ? -order : order;
      });
      table.tBodies[0].append(...rows);
    });
  });
}
