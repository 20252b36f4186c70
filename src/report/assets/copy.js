// SPDX-License-Identifier: MIT
// Where the clipboard is refused, the text is selected for the reader to copy.
async function copyText(node, press) {
  let done = 'Copied';
  try {
    await navigator.clipboard.writeText(node.textContent);
  } catch {
    getSelection().selectAllChildren(node);
    done = 'Selected';
  }
  press.textContent = done;
  setTimeout(() => { press.textContent = 'Copy'; }, 1500);
}

function startCopying() {
  for (const press of document.querySelectorAll('button.copy')) {
    press.setAttribute('aria-live', 'polite');
    press.addEventListener('click', () => copyText(press.parentElement.querySelector('code'), press));
  }
  document.getElementById('download').addEventListener('click', () => {
    const url = URL.createObjectURL(new Blob([document.getElementById('records').textContent], { type: 'application/json' }));
    el('a', { href: url, download: 'records.json' }).click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
  });
}
