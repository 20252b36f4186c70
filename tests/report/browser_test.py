# SPDX-License-Identifier: MIT
"""Opens reports in headless Chromium and uses them by mouse and keyboard. usage: browser_test.py PROGRAM
It fails where there is no chromium: a report that no browser has opened is not tested."""
import json
import os
import sys
import tempfile
import unittest

import fixtures
from browser import Browser

PROGRAM = sys.argv.pop(1)
SECTION = "#group-0"
MAIN = SECTION + " .compare canvas"
OUTPUT = SECTION + " .probe"
PICTURE = f"document.querySelector('{MAIN}').toDataURL()"
SECOND = f"document.querySelectorAll('{MAIN}')[1].toDataURL()"
CAPTION = f"document.querySelector('{SECTION} .pane figcaption').textContent"
CHOSEN = f"document.querySelector('{SECTION} .compare select').selectedOptions[0].textContent"


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="ombrage-report-")
        source = os.path.join(cls.folder.name, "small")
        cls.small = fixtures.small(PROGRAM, source)
        cls.many = fixtures.many_rows(PROGRAM, source, os.path.join(cls.folder.name, "many"))
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def setUp(self):
        self.open(self.small)

    def tearDown(self):
        """Whatever a test did, the page stayed silent and asked nobody."""
        self.assertEqual(self.browser.messages, [])
        for url in self.browser.requests:
            self.assertTrue(url.startswith(("data:", "blob:")) or url == "file://" + self.path, url[:200])

    def open(self, path):
        self.path = path
        self.browser.messages.clear()
        self.browser.requests.clear()
        self.browser.resize(1280, 900)
        seconds = self.browser.open(path)
        self.browser.middle(SECTION + " .decide")
        self.browser.wait(f"document.querySelector('{SECTION} .probe') && document.querySelector('{SECTION} .point')")
        self.browser.wait(f"document.querySelector('{MAIN}').style.height")
        return seconds

    def values(self, column):
        return self.browser.run(f"[...document.querySelectorAll('{SECTION} tbody')][0].rows.length && "
                                f"[...document.querySelector('#table-0').tBodies[0].rows].map(r => r.cells[{column}].dataset.v)")

    def focus(self, selector):
        self.browser.middle(selector)
        self.browser.run(f"document.querySelector({json.dumps(selector)}).focus()")

    def test_opens_soon_and_is_small_enough_to_mail(self):
        # A second is the aim; the machine that tests may be busy with other things.
        self.assertLess(self.open(self.small), 15)
        self.assertLessEqual(os.path.getsize(self.small), 8_000_000)
        self.assertIn("file://" + self.small, self.browser.requests, "requests are seen at all")

    def test_headings_sort_by_mouse_and_keyboard(self):
        # The third column has times, which differ.
        self.browser.click("#table-0 th:nth-child(3) button")
        up = [float(v) for v in self.values(2)]
        self.assertEqual(up, sorted(up))
        self.assertGreater(len(set(up)), 2)
        self.focus("#table-0 th:nth-child(3) button")
        self.browser.press("Enter")
        self.assertEqual([float(v) for v in self.values(2)], sorted(up, reverse=True))
        self.assertEqual(self.browser.run("document.querySelector('#table-0 th:nth-child(3)').getAttribute('aria-sort')"), "descending")
        self.browser.press(" ")
        self.assertEqual(self.browser.run("document.querySelector('#table-0 th:nth-child(3)').getAttribute('aria-sort')"), "ascending")
        self.browser.click("#table-0 th:nth-child(1) button")
        names = self.values(0)
        self.assertEqual(names, sorted(names))

    def test_a_point_of_the_plot_leads_to_its_row(self):
        # Points may cover each other, and a new choice may move none of them: those that can be hit.
        free = self.browser.run(f"""(() => {{ document.querySelector('{SECTION} .decide').scrollIntoView();
            return [...document.querySelectorAll('{SECTION} .point')].map((p, i) => [p, i]).filter(([p]) => {{
              const box = p.getBoundingClientRect();
              return document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2)?.closest('.point') === p;
            }}).map(([p, i]) => i); }})()""")
        self.assertGreaterEqual(len(free), 2)
        for index in free[:2]:
            label = self.browser.run(f"document.querySelectorAll('{SECTION} .point')[{index}].getAttribute('aria-label')")
            self.browser.run(f"document.querySelectorAll('{SECTION} .point')[{index}].id = 'aim{index}'")
            self.browser.click(f"#aim{index}")
            name = label.split(":")[0]
            self.assertEqual(self.browser.run("document.activeElement.cells[0].dataset.v"), name)
            self.assertEqual(self.browser.run("document.querySelector('#table-0 tr.picked').cells[0].dataset.v"), name)
            self.assertEqual(self.browser.run(CHOSEN), name, "the comparison shows it")

    def test_the_plot_by_keyboard(self):
        self.focus(SECTION + " .point[tabindex='0']")
        first = self.browser.run("document.activeElement.getAttribute('aria-label')")
        self.browser.press("ArrowRight")
        second = self.browser.run("document.activeElement.getAttribute('aria-label')")
        self.assertNotEqual(first, second)
        self.assertEqual(self.browser.run(f"document.querySelectorAll('{SECTION} .point[tabindex=\"0\"]').length"), 1, "one stop for Tab")
        self.browser.press("Enter")
        self.assertEqual(self.browser.run("document.activeElement.cells[0].dataset.v"), second.split(":")[0])

    def test_the_axes_can_be_changed(self):
        before = self.browser.run(f"document.querySelector('{SECTION} .point').getAttribute('transform')")
        self.browser.click(SECTION + " .plot input")
        self.browser.run(f"(() => {{ const s = document.querySelectorAll('{SECTION} .plot select')[1]; s.selectedIndex = s.options.length - 1;"
                         "s.dispatchEvent(new Event('change')); })()")
        self.assertNotEqual(self.browser.run(f"document.querySelector('{SECTION} .point').getAttribute('transform')"), before)
        self.assertIn("CPU [ms]", self.browser.run(f"document.querySelector('{SECTION} .chart').textContent"))

    def test_the_slider_by_keyboard_and_mouse(self):
        self.focus(SECTION + " .split")
        before = self.browser.run(PICTURE)
        for _ in range(10):
            self.browser.press("ArrowLeft")
        self.assertEqual(self.browser.run(f"document.querySelector('{SECTION} .split').value"), "40")
        self.assertNotEqual(self.browser.run(PICTURE), before)
        x, y, width, _ = self.browser.middle(MAIN)
        self.browser.mouse("mousePressed", x - 0.1 * width, y)
        self.browser.mouse("mouseMoved", x + 0.3 * width, y)
        self.browser.mouse("mouseReleased", x + 0.3 * width, y)
        # A pixel of the pane is a third of a per cent.
        self.assertAlmostEqual(float(self.browser.run(f"document.querySelector('{SECTION} .split').value")), 80, delta=1)

    def test_space_flips_between_technique_and_truth(self):
        self.browser.click(SECTION + " .compare button[data-mode=flip]")
        self.browser.mouse("mouseMoved", 1, 1)
        self.focus(MAIN)
        technique = self.browser.run(PICTURE)
        self.assertIn("A " + self.browser.run(CHOSEN) + " (shown)", self.browser.run(CAPTION))
        self.browser.press(" ")
        self.assertIn("B truth (shown)", self.browser.run(CAPTION))
        self.assertNotEqual(self.browser.run(PICTURE), technique)
        self.browser.press(" ")
        self.assertEqual(self.browser.run(PICTURE), technique)

    def test_the_probe_reads_both_pictures(self):
        self.browser.run(f"document.querySelector('{SECTION} .compare select').selectedIndex = 0;"
                         f"document.querySelector('{SECTION} .compare select').dispatchEvent(new Event('change'))")
        x, y, width, height = self.browser.middle(MAIN)
        self.browser.mouse("mouseMoved", x + 0.2 * width, y + 0.1 * height)
        text = self.browser.run(f"document.querySelector('{OUTPUT}').textContent")
        # The same two pixels, read from the pictures by another way.
        expected = self.browser.run("""(async () => {
            const record = JSON.parse(document.getElementById('records').textContent).records[0];
            return Promise.all(['visibility', 'truth'].map(async kind => {
              const image = [...document.images].find(i => i.dataset.path === record.images[kind]);
              const bitmap = await createImageBitmap(image), canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
              canvas.getContext('2d').drawImage(bitmap, 0, 0);
              return (canvas.getContext('2d').getImageData(bitmap.width * 0.7, bitmap.height * 0.6, 1, 1).data[0] / 255).toFixed(3);
            }));
        })()""")
        self.assertIn(f": {expected[0]} ·", text)
        self.assertIn(f"truth: {expected[1]} ·", text)
        self.assertIn("class of A:", text)
        # 160 pixels in 1280: the middle of the picture and 0.2 of its width to the right.
        self.assertRegex(text, r"^Pixel 11[12], 5[34] ")

    def test_the_probe_and_the_zoom_by_keyboard(self):
        self.focus(MAIN)
        self.browser.press("ArrowRight")
        first = self.browser.run(f"document.querySelector('{OUTPUT}').textContent")
        self.browser.press("ArrowRight", shift=True)
        second = self.browser.run(f"document.querySelector('{OUTPUT}').textContent")
        pixel = [int(t.split("Pixel ")[1].split(",")[0]) for t in (first, second)]
        self.assertEqual(pixel[1] - pixel[0], 10)
        main, beside = self.browser.run(PICTURE), self.browser.run(SECOND)
        self.browser.press("+")
        self.assertNotEqual(self.browser.run(PICTURE), main)
        self.assertNotEqual(self.browser.run(SECOND), beside, "the zoom is linked")
        self.browser.press("0")
        self.assertEqual([self.browser.run(PICTURE), self.browser.run(SECOND)], [main, beside])
        shown = f"document.querySelector('{SECTION} .pane:last-child figcaption').textContent"
        before = self.browser.run(f"document.querySelectorAll('{SECTION} .pane')[1].textContent")
        self.browser.press("e")
        self.assertNotEqual(self.browser.run(f"document.querySelectorAll('{SECTION} .pane')[1].textContent"), before, shown)

    def test_a_crop_leads_to_its_place(self):
        self.focus(SECTION + " .croprow figure[data-record]")
        caption = self.browser.run("document.activeElement.textContent")
        before = self.browser.run(PICTURE)
        self.browser.press("Enter")
        self.assertTrue(caption.startswith(self.browser.run(CHOSEN)), caption)
        self.assertNotEqual(self.browser.run(PICTURE), before)

    def test_tab_reaches_everything_and_the_focus_is_seen(self):
        self.browser.run("document.activeElement.blur(); scrollTo(0, 0); getSelection().removeAllRanges()")
        self.browser.open(self.small)
        seen = []
        for _ in range(120):
            self.browser.press("Tab")
            seen.append(self.browser.run("(() => { const a = document.activeElement, s = getComputedStyle(a), h = a.querySelector('.halo');"
                                         "const ring = s.outlineStyle !== 'none' || (h && getComputedStyle(h).stroke !== 'none');"
                                         "return [a.id || a.className.baseVal || a.className || a.tagName, ring,"
                                         "a.getBoundingClientRect().width > 0]; })()"))
            if any("copy" in name for name, _, _ in seen):
                break
        self.assertEqual(seen[0][0], "theme")
        for name, ring, visible in seen:
            self.assertTrue(ring and visible, name)
        reached = " ".join(name for name, _, _ in seen)
        for part in ("point", "CANVAS", "split", "pick", "SELECT", "wide"):
            self.assertIn(part, reached)

    def test_everything_that_can_be_used_has_a_name(self):
        nodes = self.browser.command("Accessibility.getFullAXTree")["nodes"]
        used = {"button", "combobox", "slider", "checkbox", "link", "application", "region", "img", "image"}
        roles = set()
        for node in nodes:
            role = node.get("role", {}).get("value")
            if node.get("ignored") or role not in used:
                continue
            roles.add(role)
            self.assertTrue(node.get("name", {}).get("value"), node)
        self.assertLessEqual({"button", "combobox", "slider", "checkbox", "link", "application"}, roles)
        self.assertEqual(self.browser.run("[...document.images].filter(i => !i.alt).length"), 0)
        self.assertEqual(self.browser.run("(() => { const ids = [...document.querySelectorAll('[id]')].map(n => n.id);"
                                          "return ids.length - new Set(ids).size; })()"), 0)

    def test_light_and_dark(self):
        ground = "getComputedStyle(document.body).backgroundColor"
        self.browser.scheme("dark")
        dark = self.browser.run(ground)
        self.browser.scheme("light")
        light = self.browser.run(ground)
        self.assertNotEqual(dark, light)
        self.browser.click("#theme")
        self.assertEqual(self.browser.run(ground), light)
        self.browser.click("#theme")
        self.assertEqual(self.browser.run(ground), dark, "the choice overrules the system")
        self.browser.click("#theme")
        self.assertEqual(self.browser.run("document.querySelector('#theme').textContent"), "Theme: system")

    def test_paper_has_headings_plots_and_whole_tables(self):
        # Sections that were never seen are drawn at the moment of printing, without waiting for a frame.
        empty = self.browser.run("""(() => {
            dispatchEvent(new Event('beforeprint'));
            return [...document.querySelectorAll('svg.chart')].filter(chart => !chart.childElementCount).length; })()""")
        self.assertEqual(empty, 0)
        self.assertGreater(self.browser.run("document.querySelectorAll('.times svg.chart').length"), 1)
        self.browser.resize(720, 1000)  # A4 less margins, at 96 pixels an inch
        self.browser.command("Emulation.setEmulatedMedia", media="print")
        try:
            self.assertEqual(self.browser.run("[...document.querySelectorAll('thead th')].filter(h => !h.innerText.trim()).length"), 0)
            widest = self.browser.run("Math.max(...[...document.querySelectorAll('table')].map(t => t.getBoundingClientRect().right))")
            self.assertLessEqual(widest, 720)
        finally:
            self.browser.command("Emulation.setEmulatedMedia", media="")

    def test_a_narrow_screen_scrolls_down_only(self):
        self.browser.resize(400, 800)
        self.browser.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), 400)

    def test_commands_are_copied_and_records_downloaded(self):
        self.browser.click("#environment button.copy")
        self.browser.wait("['Copied', 'Selected'].includes(document.querySelector('#environment button.copy').textContent)")
        self.browser.command("Page.setDownloadBehavior", behavior="allow", downloadPath=self.folder.name)
        self.browser.click("#download")
        file = os.path.join(self.folder.name, "records.json")
        for _ in range(100):
            if os.path.exists(file):
                break
            self.browser.run("new Promise(done => setTimeout(done, 100))")
        with open(file, encoding="utf-8") as text:
            self.assertEqual(text.read(), self.browser.run("document.getElementById('records').textContent"))

    def test_benches_of_the_folder_are_shown_with_their_samples(self):
        self.assertEqual(self.browser.run("document.querySelectorAll('#bench table tbody tr').length"), 2)
        self.assertEqual(self.browser.run("document.querySelectorAll('#bench .spark polyline').length"), 2)
        self.assertGreaterEqual(self.browser.run("document.querySelectorAll('#bench circle.dot').length"), 2 * 12)
        # The figure that decides stands beside what it decides.
        text = self.browser.run("document.querySelector('#bench').innerText")
        self.assertIn("process [ms]", text)
        self.assertRegex(text, r"Differences are of the (processor|GPU) time")
        self.assertRegex(text, r": [+-]?[0-9.]+ %, 99 % interval [+-]?[0-9.]+ % to [+-]?[0-9.]+ %")

    def test_many_rows_and_names_that_are_markup(self):
        self.open(self.many)
        rows = "document.querySelector('#table-0').tBodies[0].rows"
        self.assertEqual(self.browser.run(rows + ".length"), fixtures.MANY)
        self.assertEqual(self.browser.run(f"document.querySelectorAll('{SECTION} .point').length"), fixtures.MANY)
        self.browser.click("#table-0 th:nth-child(2) button")
        errors = [float(v) for v in self.values(1)]
        self.assertEqual(errors, sorted(errors))
        self.browser.click(f"{SECTION} .pick")
        self.assertEqual(self.browser.run("document.title"), "Ombrage report")
        self.assertEqual(self.browser.run("document.querySelectorAll('script').length"), 4)
        self.assertIn(fixtures.EVIL, self.browser.run("document.querySelector('#group-0 h2').textContent"))
        self.browser.resize(400, 800)
        self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), 400)


if __name__ == "__main__":
    unittest.main(verbosity=2)
