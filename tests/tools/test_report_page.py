# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""The page of tools/report, of made-up runs: it needs nothing but itself, all its sections and the runs that its numbers lead to are there, and it is made
again from what was stored."""

import html.parser
import os
import re
import shutil
import subprocess
import unittest

import h5py

from interphase import run_sheet
from scratch import read, write_results
from test_report import Folder

SECTIONS = ["summary", "findings", "snapshots", "pressure", "velocity", "temperature", "overlaps", "voidage", "cost", "trade", "numbers", "notes", "runs"]


class Page(html.parser.HTMLParser):
    """Ids, links, addresses of pictures and the tags that are open."""

    VOID = {"meta", "img", "br"}

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.sources, self.open, self.alts, self.tags = [], [], [], [], [], set()
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.tags.add(tag)
        self.ids += [found["id"]] if "id" in found else []
        self.links += [found["href"]] if "href" in found else []
        self.sources += [found["src"]] if "src" in found else []
        self.alts += [found.get("alt", "")] if tag == "img" else []
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class Pages(Folder):
    def page(self, *given):
        path = os.path.join(self.root, "page.html")
        self.report(*given, "--html", path)
        text = read(path)
        found = Page(text)
        self.assertEqual(found.open, [])
        self.assertTrue(all(each.startswith("#") and each[1:] in found.ids for each in found.links), found.links)
        self.assertTrue(all(each.startswith("data:") for each in found.sources))
        self.assertFalse(re.search(r"https?://|<script|<link|url\(|@import", re.sub(r'src="data:[^"]*"', "", text)))
        self.assertEqual(len(found.ids), len(set(found.ids)))
        self.assertTrue(all(found.alts))
        self.assertLessEqual(set(SECTIONS), set(found.ids))
        return text, found

    def test_one_run(self):
        text, found = self.page(self.run_of("one"), "--no-write")
        self.assertIn("One run alone has no distance", text)
        self.assertIn("run-1", found.ids)
        self.assertIn("img", found.tags)

    def test_four_runs_each_number_leads_to_its_run(self):
        runs = [self.run_of(f"run{n}", seed=n, shift=0.4 * (n == 4)) for n in range(1, 5)]
        for run, method in zip(runs, ("DEM", "TDHS", "CGPM", "MPPIC")):
            with h5py.File(os.path.join(run, "results.h5"), "r+") as file:
                file["meta"].attrs["method"] = method
                file["meta"].attrs["simulated_time"] = 3.0
        text, found = self.page(*runs, "--no-write", "--from", "0.5", "--reference", "run2")
        for at in range(1, 5):
            self.assertGreater(found.links.count(f"#run-{at}"), 20)
        self.assertIn("<h3>run2</h3>", text[text.index('id="run-1"'):][:200])
        self.assertIn("reference", text)
        self.assertIn("The pressure drop does not tell".lower(), text.lower())  # a claim of the paper
        self.assertIn("4 s of wall time", text)  # 12 s for 3 simulated ones

    def test_runs_without_gas_or_snapshots_say_so(self):
        folder = os.path.join(self.root, "bare")
        write_results(folder, {"time": [0.1 * n for n in range(40)], "kinetic_energy": [1 + 0.01 * (n % 3) for n in range(40)]}, weight=1, wall_time=1.0)
        text, _ = self.page(folder, "--no-write", "--from", "1")
        for words in ("no snapshots are at hand", "no snapshots or rows of statistics were recorded", "no pressure profile"):
            self.assertIn(words, text)

    def test_it_is_made_again_from_what_was_stored(self):
        runs, kept = [self.run_of("a", 200, 1), self.run_of("b", 200, 2)], os.path.join(self.root, "kept")  # long enough for a spectrum
        first, drawn = self.page(*runs, "--no-write", "--from", "0.5", "--store", kept)
        for run in runs:
            shutil.rmtree(run)
        again, drawn_again = self.page(kept)
        of_runs = [alt for alt in drawn.alts if alt not in drawn_again.alts]
        self.assertTrue(all(alt.startswith("the particles of") for alt in of_runs), of_runs)
        self.assertIn("the pressure drop's spectrum or series of each run", drawn_again.alts)

        def numbers(text):
            return re.findall(r'<a href="#run-\d+">([^<]*\+- [^<]*)</a>', text)

        self.assertGreater(len(numbers(first)), 50)
        self.assertEqual(numbers(first), numbers(again))
        for path in run_sheet.stored_in(kept):
            self.assertLess(os.path.getsize(path), 60_000)
            self.assertNotIn(self.root, read(path))  # it tells nothing of this machine's folders
            self.assertEqual(run_sheet.as_text(run_sheet.read(path)), read(path))

    def test_bad_input(self):
        run, kept = self.run_of("a"), os.path.join(self.root, "kept")
        self.report(run, "--no-write", "--from", "0.5", "--store", kept)
        for given, words in (
            ((run, kept), "not both"), ((kept, "--from", "1"), "has been measured already"), ((run, "--html", "page.png"), "ends with .html"),
            ((run, "--html", "/nowhere/page.html"), "there is no folder"), ((run, "--no-write", "--reference", "b"), "is none of the runs: "),
            ((run, "--own-time", "--until", "2"), "give one of them"),
        ):
            self.assertIn(words, self.report(*given, code=2))
        path, = run_sheet.stored_in(kept)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write('{"kind": "sheet of a run of interphase", "sheet": {"class": "os.system"}}')
        self.assertIn("it may be of another version", self.report(kept, code=2))

    def test_a_browser_shows_it_whole_on_a_phone(self):
        browser = shutil.which("chromium") or shutil.which("google-chrome")
        if browser is None:
            self.skipTest("no chromium: apt-get install chromium")
        self.page(self.run_of("a", seed=1), self.run_of("b", seed=2), "--no-write", "--from", "0.5")
        # With the width of a phone nothing but tables, which scroll by themselves, is wider than the page.
        path = os.path.join(self.root, "page.html")
        text = read(path).replace("</body>", "<script>document.title = 'wide ' + document.documentElement.scrollWidth + ' of ' + innerWidth + ' broken ' + "
                                             "[...document.images].filter(i => !i.naturalWidth).length</script></body>")  # fmt: skip
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        done = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=500,900", f"--user-data-dir={self.root}/browser",
                               "--dump-dom", f"file://{path}"], capture_output=True, text=True, timeout=600)  # fmt: skip
        wide, across, broken = map(int, re.search(r"<title>wide (\d+) of (\d+) broken (\d+)</title>", done.stdout).groups())
        self.assertLessEqual(wide, across)
        self.assertEqual(broken, 0)


if __name__ == "__main__":
    unittest.main()
