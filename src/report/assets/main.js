// SPDX-License-Identifier: MIT
startTheme();
startCopying();
startBenches();
for (const table of document.querySelectorAll('table.sortable')) startSorting(table);
for (const section of document.querySelectorAll('section.overview')) startPareto(section);
// A report may hold many scenes: the work for each is done when it comes near.
const nearby = new IntersectionObserver(entries => {
  for (const { isIntersecting, target } of entries)
    if (isIntersecting) startSection(target);
}, { rootMargin: '800px' });

function startSection(section) {
  nearby.unobserve(section);
  if (section.dataset.ready) return;
  section.dataset.ready = 'yes';
  startPareto(section);
  startTimes(section);
  startCrops(section);
  const comparison = new Comparison(section, section.querySelector('.compare'));
  for (const press of section.querySelectorAll('.pick'))
    press.addEventListener('click', () => pickRun(section, Number(press.closest('tr').dataset.record)));
  if (comparison.main) comparison.markRow();
}

for (const section of document.querySelectorAll('section.measured')) nearby.observe(section);
addEventListener('beforeprint', () => {
  document.querySelectorAll('section.measured').forEach(startSection);
  document.querySelectorAll('details').forEach(details => { details.open = true; });
  drawNow();
});
document.documentElement.dataset.ready = 'yes';
