# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of tools/report: what several runs measured, in the order of the paper's figures 3 to 14, what of it is decided, and where each number is from."""

import math

from interphase import findings, page_convergence, page_figures, page_html, page_replicates, report_figure, report_table, trade
from interphase.page_html import link, listed, paragraph, section, table, text
from interphase.report_table import shown

VERDICTS = (findings.FOUND, findings.NOT_FOUND, findings.UNDECIDED)


class Page:
    """Of `sheets` (run_sheet.Sheet), the first of which is the reference; windows at `depth`; `notes` of the whole. `pictures`: HTML of snapshots and film,
    "" where there are none; `confidence` of agreement, of all quantities together. `counted`: the quantities of the distance, None: all."""

    def __init__(self, title, sheets, depth, notes=(), pictures="", confidence=0.95, counted=None):
        self.title, self.sheets, self.depth, self.notes, self.pictures, self.confidence = title, sheets, depth, list(notes), pictures, confidence
        self.names = [sheet.name for sheet in sheets]
        self.reports = [sheet.report for sheet in sheets]
        self.reference = sheets[0]
        self.distances = {sheet.name: trade.distances(self.reference.report, sheet.report, depth, counted) for sheet in sheets[1:]}
        self.points = [trade.Point(sheet.name, sheet.account.cost, None if at == 0 else trade.overall(self.distances[sheet.name]))
                       for at, sheet in enumerate(sheets)]  # fmt: skip
        self.panels = report_figure.panels(self.reports, depth, self.reference.scene)

    def html(self):
        """The page's text."""
        parts = [
            ("summary", "In short", self._summary()),
            ("findings", "What the paper found", self._findings()),
            ("snapshots", "Snapshots", self.pictures or paragraph("No pictures: no snapshots are at hand.")),
            ("pressure", "Pressure", self._pressure()),
            ("velocity", "Velocity of the particles", self._panels(("vertical velocity", "horizontal velocity"))),
            ("temperature", "Granular temperature", self._panels(("granular temperature",))),
            ("overlaps", "Overlaps", self._panels(("overlaps",), self._quantities(lambda report: report.overlaps))),
            ("voidage", "Voidage", self._panels(("voidage",), self._quantities(lambda report: report.voidages))),
            ("cost", "Cost", self._cost()),
            ("trade", "Cost against accuracy", self._trade()),
            ("numbers", "All numbers", self._numbers()),
            ("notes", "What is not decided, and why", self._notes()),
            ("runs", "Runs", self._runs()),
        ]
        if converging := page_convergence.section(self.sheets, self.depth, self._to_run, distance_words):
            parts.insert(-3, ("convergence", "Smaller parcels, smaller steps", converging))
        if repeated := page_replicates.section(self.sheets, self.depth, self._to_run):
            parts.insert(-3, ("replicates", "Replicates", repeated))
        contents = [(name, words) for name, words, _ in parts]
        return page_html.page(self.title, contents, "\n".join(section(name, words, inside) for name, words, inside in parts))

    def run(self, at):
        """The id of a run's entry."""
        return f"run-{at + 1}"

    def _to_run(self, name, words=None):
        return link(self.run(self.names.index(name)), name if words is None else words)

    def _number(self, at, words):
        """Which leads to its run."""
        return link(self.run(at), words)

    def _heads(self):
        return [self._to_run(name) for name in self.names]

    def _summary(self):
        best = trade.best(self.points) if len(self.points) > 1 else []
        rows = []
        for at, (sheet, point) in enumerate(zip(self.sheets, self.points)):
            account = sheet.account
            measured = sheet.report.snapshots or sheet.report.rows[0]
            rows.append([self._to_run(sheet.name), text(account.method), text(f"{account.weight:g}"),
                         self._number(at, f"{sheet.report.first:.4g} to {sheet.report.last:.4g} s, {measured}"), self._number(at, cost_words(point.cost)),
                         "reference" if at == 0 else self._number(at, distance_words(point.distance))])  # fmt: skip
        same = len({(sheet.start, sheet.end) for sheet in self.sheets}) == 1
        words = f"Over {self.reference.start:.4g} to {self.reference.end:.4g} s ({self.reference.how})." if same else "Each run over its own time."
        kinds = sorted({point.cost.kind for point in self.points if point.cost})
        more = paragraph("None of these is beaten in both, cost and distance: " + ", ".join(self._to_run(name) for name in best) + ".") if best else ""
        return (paragraph(text(words)) + table(["run", "method", "W", "measured, samples", f"cost [s/s, {' or '.join(kinds) or 'not known'}]", "distance to the reference"], rows)
                + more + paragraph(f"How distance is meant: {link('trade', 'Cost against accuracy')}. Every number leads to its run."))  # fmt: skip

    def _findings(self):
        found = findings.of(self.sheets, self.depth)
        if not found:
            return paragraph("None of its claims can be asked of these runs: they are of DEM or TDHS beside other methods.")
        counts = ", ".join(f"{sum(each.verdict == verdict for each in found)} {verdict}" for verdict in VERDICTS)
        items = [f"<strong>{text(each.verdict)}</strong>: {text(each.claim)}.<br>{text(each.reason)} "
                 f"({', '.join(self._to_run(name) for name in dict.fromkeys(each.runs))})" for each in found]  # fmt: skip
        return paragraph(f"{counts}. The margins stand beside the numbers; +- is the half width at 95 %.") + listed(items)

    def _panels(self, names, more=""):
        drawn = [page_figures.panel(self.panels[name], self.names, f"{name} of each run", name.capitalize() + ".") for name in names if name in self.panels]
        if not drawn:
            return paragraph(f"Not measured: {text(self._why_missing())}.")
        return f'<div class="figures">{"".join(drawn)}</div>{more}'

    def _why_missing(self):
        return "no snapshots or rows of statistics were recorded" if not any(report.snapshots for report in self.reports) else \
            "what the runs recorded, or what was asked for, has none of it"

    def _quantities(self, of):
        """A table of the `Quantity`s that `of(report)` gives."""
        every = {}
        for at, report in enumerate(self.reports):
            for quantity in of(report):
                every.setdefault((quantity.name, quantity.unit, quantity.shown_times), {})[at] = quantity.mean
        rows = [[text(f"{name} [{unit}]" if unit not in ("", "1") else name),
                 *(self._number(at, shown(means.get(at), times)) for at in range(len(self.names)))] for (name, unit, times), means in every.items()]  # fmt: skip
        return table(["", *self._heads()], rows) if rows else ""

    def _pressure(self):
        figures = []
        profiles = [sheet.profile for sheet in self.sheets]
        if any(profile is not None for profile in profiles):
            figures.append(page_figures.pressure_profile(profiles, self.names))
        if "pressure" in self.panels:
            figures.append(page_figures.panel(self.panels["pressure"], self.names, "the pressure drop's spectrum or series of each run",
                                              "Pressure drop between the taps: its spectrum, or its series where a record is short."))  # fmt: skip
        missing = [f"{text(sheet.name)}: {text(sheet.profile_missing)}" for sheet in self.sheets if sheet.profile is None and sheet.profile_missing]
        series = self._quantities(lambda report: report.series)
        if not figures and not series:
            return paragraph("Not measured: the runs recorded no pressure drop and no fields of the gas.") + listed(missing)
        return f'<div class="figures">{"".join(figures)}</div>' + series + listed(missing)

    def _cost(self):
        costs = [sheet.account.cost for sheet in self.sheets]
        if not any(costs):
            return paragraph("Not known: the runs tell neither wall time nor CPU time.")
        rows = []
        for at, (name, cost) in enumerate(zip(self.names, costs)):
            split = cost.split if cost else {}
            rows.append([self._to_run(name), self._number(at, cost_words(cost)), text(cost.kind if cost else "-"),
                         *(self._number(at, f"{split[part]:.3g}" if part in split else "-") for part in page_figures.PARTS)])  # fmt: skip
        kinds = {cost.kind for cost in costs if cost}
        mixed = " Runs of both kinds are here: their ratios are not to be trusted on a machine that did other work, too." if len(kinds) > 1 else ""
        wall = " Wall time holds what other programs took of the cores." if "wall time" in kinds else ""
        return (page_figures.cost_split(costs, self.names) + table(["run", "s per simulated second", "of", *page_figures.PARTS], rows)
                + paragraph("Error: scatter of the pace over the run. Phases: by the program's own processor time, or, in a run without rows of it, shares of its wall-clock "
                            f"time, the slowest rank's; coupling is mapping and exchange, other is the rest.{wall}{mixed}"))  # fmt: skip

    def _trade(self):
        if len(self.sheets) < 2:
            return paragraph("One run alone has no distance: give others, the reference first.")
        drawn = [page_figures.trade(self.points, self.names, "overall")]
        every = list(dict.fromkeys(each.quantity for found in self.distances.values() for each in found))
        of = {name: {each.quantity: each for each in found} for name, found in self.distances.items()}
        for quantity in every:
            points = [trade.Point(self.names[0], self.points[0].cost, None)]
            points += [trade.Point(point.name, point.cost, of[point.name][quantity]) for point in self.points[1:] if quantity in of[point.name]]
            if len(points) == len(self.points) and any(math.isfinite(point.distance.square) for point in points[1:]):
                drawn.append(page_figures.trade(points, self.names, quantity))
        rows = [[text(quantity), *(self._number(at, distance_words(of[name].get(quantity))) for at, name in enumerate(self.names[1:], 1))] for quantity in every]
        rows.append(["<strong>overall</strong>", *(self._number(at, distance_words(point.distance)) for at, point in enumerate(self.points[1:], 1))])
        scales = dict.fromkeys(f"{each.quantity}: {each.scale}" for found in self.distances.values() for each in found
                               if each.scale not in ("the reference's value", f"the reference's {each.quantity}, root mean square"))
        return (f'<div class="figures">{"".join(drawn)}</div>' + table(["distance to " + self._to_run(self.names[0]), *self._heads()[1:]], rows)
                + listed(map(text, self._words_on_trade()))
                + paragraph("Distance: difference of the means over the reference's own value (of profiles and classes: root mean square of the differences over "
                            "that of the reference). What errors alone bring is taken off the square: two equal runs are at 0 on average. Bars are one standard "
                            "error; grey reaches up to the distance that noise alone makes. <em>told apart</em>: at 95 %, Student's t, over all parts of the "
                            "quantity. Overall: root mean square of the quantities, without overlaps, which are the method's own choice, and the strongest frequency, as peaks are often alike. "
                            + text("; ".join(scales))))  # fmt: skip

    def _words_on_trade(self):
        """A sentence a run: how much cheaper, how far, and what is not decided."""
        for point in self.points[1:]:
            yield f"{point.name}: {self._words_on_cost(point)}{trade.words_on(self.distances[point.name])}."

    def _words_on_cost(self, point):
        """Beside the first run's; "" where one of both is not known."""
        base = self.points[0].cost
        if not (base and point.cost):
            return ""
        ratio = point.cost.value / base.value
        return f"costs {ratio:.3g} times {self.names[0]}; " if ratio > 1 else f"costs 1/{1 / ratio:.3g} of {self.names[0]}; "

    def _numbers(self):
        sections = [report_table.quantities(report, self.depth) for report in self.reports]
        keys = list(dict.fromkeys((heading, quantity.name) for each in sections for heading, some in each for quantity in some))
        if not keys:
            return paragraph("No means: nothing was recorded that has one.")
        found = [{(heading, quantity.name): quantity for heading, some in each for quantity in some} for each in sections]
        any_of = {key: next(each[key] for each in found if key in each) for key in keys}
        means = [[each[key].mean if key in each else None for key in keys] for each in found]
        judgeable = [at for at, (heading, _) in enumerate(keys) if heading != "spheres in a window"]
        picked = [[column[at] for at in judgeable] for column in means]
        verdicts = dict(zip(judgeable, report_table.judged(picked[0], picked[1:], self.confidence)))
        rows = []
        for at, (heading, name) in enumerate(keys):
            quantity = any_of[heading, name]
            label = f"{heading.split(' [')[0]}, {name.strip()}" if heading else name
            unit = heading.partition(" [")[2].rstrip("]") or quantity.unit
            rows.append([text(f"{label} [{unit}]" if unit not in ("", "1") else label),
                         *(self._number(run, shown(column[at], quantity.shown_times)) for run, column in enumerate(means)),
                         *(text(f"{each.ratio:+.1f} {each.verdict}" if math.isfinite(each.ratio) else each.verdict) for each in verdicts.get(at, ()))])  # fmt: skip
        head = ["", *self._heads(), *(f"{text(name)} - {text(self.names[0])}" for name in self.names[1:])]
        return table(head, rows) + paragraph(
            "Mean +- standard error, autocorrelation taken in; ? where the error is not to be trusted. Differences: over their standard error, and whether the runs "
            f"agree, at {100 * self.confidence:g} % for all quantities together.")  # fmt: skip

    def _notes(self):
        items = [text(note) for note in self.notes]
        for sheet in self.sheets:
            items += [f"{self._to_run(sheet.name)}: {text(note)}" for note in sheet.report.notes]
            doubted = [(name, mean.reason) for name, (_, means) in trade.quantities(sheet.report, self.depth).items() for mean in means if mean and mean.reason]
            if doubted:
                names = ", ".join(dict.fromkeys(name for name, _ in doubted))
                items.append(f"{self._to_run(sheet.name)}: errors not to be trusted of {text(names)}, such as: {text(doubted[0][1])}")
        return listed(items) or paragraph("Nothing to add: all errors are to be trusted.")

    def _runs(self):
        entries = []
        for at, sheet in enumerate(self.sheets):
            account = sheet.account
            known = lambda value, unit="": f"{value:.6g}{unit}" if math.isfinite(value) else ""  # noqa: E731
            facts = (("folder", account.folder), ("command", account.command), ("commit", account.commit), ("versions", account.versions),
                     ("date", account.date), ("processor", account.machine), ("ranks", str(account.ranks)), ("spheres tracked", known(account.particles)),
                     ("gas step", known(account.gas_step, " s")), ("solid step", known(account.solid_step, " s")), ("began with", account.start),
                     ("simulated", known(account.simulated, " s")), ("wall time", known(account.wall, " s")), ("CPU time", known(account.cpu, " s")),
                     ("state", account.state), ("measured", f"{sheet.report.snapshots} samples, {sheet.report.rows[0]} rows of series"))  # fmt: skip
            inside = "".join(f"<dt>{text(name)}</dt><dd>{f'<code>{text(value)}</code>' if name in ('folder', 'command', 'commit') else text(value)}</dd>"
                             for name, value in facts if value)  # fmt: skip
            entries.append(f'<article id="{self.run(at)}"><h3>{text(sheet.name)}</h3><dl>{inside}</dl></article>')
        versions = {sheet.account.commit for sheet in self.sheets if sheet.account.commit}
        mixed = paragraph("These runs are of different versions of the program: " + text("; ".join(sorted(versions)))) if len(versions) > 1 else ""
        return mixed + "".join(entries)


def cost_words(cost):
    """Of a `Cost` or None."""
    if cost is None or not math.isfinite(cost.value):
        return "-"
    return f"{cost.value:.3g}" + (f" +- {cost.error:.2g}" if math.isfinite(cost.error) else "")


def distance_words(distance):
    """Of a `Distance` or None: value, range of one standard error, and whether it is told from 0."""
    if distance is None or not math.isfinite(distance.square):
        return "-"
    if not math.isfinite(distance.square_error):
        return f"{distance.value:.3g}, error not known"
    if math.isnan(distance.chance):
        apart = "not decided"
    else:
        apart = "told apart" if distance.told_apart else "not told apart"
    return f"{distance.value:.3g} ({distance.low:.2g} to {distance.high:.2g}), {apart}" + (" ?" if distance.reason else "")
