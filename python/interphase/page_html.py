# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces of a page in HTML that needs nothing but itself: no network, no scripts; pictures and films are inside."""

import base64
import html
import io

from matplotlib import pyplot

STYLE = """
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #1c1c1c; background: #fff; margin: 0 auto; max-width: 68rem; padding: 0 1rem 4rem;
  overflow-wrap: break-word; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 1.5rem 0 .5rem; }
h2 { font-size: 1.2rem; border-top: 1px solid #ccc; padding-top: 1rem; margin-top: 2rem; }
h3 { font-size: 1rem; margin-bottom: .3rem; }
nav ul { display: flex; flex-wrap: wrap; gap: .2rem 1rem; list-style: none; padding: 0; }
a { color: #0b57a4; }
td a, th a { color: inherit; text-decoration: underline dotted #999; text-underline-offset: .2em; }
.figures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; max-width: 100%; }
figcaption, .note { color: #444; font-size: .9rem; }
img, video { max-width: 100%; height: auto; display: block; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .2rem .8rem .2rem 0; border-bottom: 1px solid #e4e4e4; vertical-align: top; }
td { white-space: nowrap; }
li { margin-bottom: .5rem; }
nav li { margin: 0; }
thead th { border-bottom: 2px solid #888; }
dt { font-weight: 600; } dd { margin: 0 0 .4rem 0; }
code { font-size: .9em; overflow-wrap: anywhere; }
"""


def text(words):
    """`words` as they stand, with what HTML would take for its own made harmless."""
    return html.escape(str(words))


def link(target, words):
    """To the element of the page whose id is `target`."""
    return f'<a href="#{html.escape(target)}">{text(words)}</a>'


def table(head, rows):
    """`head`: cells of the first line; `rows`: lists of cells; all of them HTML."""
    lines = ["<tr>" + "".join(f'<th scope="col">{cell}</th>' for cell in head) + "</tr>"]
    body = []
    for row in rows:
        cells = [f'<th scope="row">{row[0]}</th>'] + [f"<td>{cell}</td>" for cell in row[1:]]
        body.append("<tr>" + "".join(cells) + "</tr>")
    return ('<div class="wide"><table><thead>' + "".join(lines) + "</thead>\n<tbody>" + "\n".join(body) + "</tbody></table></div>")


def section(name, title, *parts):
    """With the id `name`; parts are HTML, empty ones are left out."""
    inside = "\n".join(part for part in parts if part)
    return f'<section id="{name}"><h2>{text(title)}</h2>\n{inside}\n</section>'


def paragraph(words):
    return f"<p>{words}</p>"


def listed(items):
    """A list of HTML items, nothing where there are none."""
    return "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>" if items else ""


def data_uri(kind, content):
    """`content` (bytes) of the MIME type `kind`, as an address."""
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def image(kind, content, words, caption=""):
    """A figure; `words` say what is to be seen, for those who cannot."""
    below = f"<figcaption>{caption}</figcaption>" if caption else ""
    return f'<figure><img src="{data_uri(kind, content)}" alt="{html.escape(words, quote=True)}">{below}</figure>'


def film(kind, content, words, caption=""):
    """A film that begins by itself and again; an animated picture is an image."""
    below = f"<figcaption>{caption}</figcaption>" if caption else ""
    what = html.escape(words, quote=True)
    return (f'<figure><video src="{data_uri(kind, content)}" aria-label="{what}" autoplay loop muted playsinline controls></video>{below}</figure>')


def drawn(figure, words, caption=""):
    """A figure of matplotlib, which is closed, as one of the page."""
    stream = io.BytesIO()
    # Without a date the same numbers make the same bytes.
    figure.savefig(stream, format="svg", metadata={"Date": None})
    pyplot.close(figure)
    return image("image/svg+xml", stream.getvalue(), words, caption)


def page(title, contents, body):
    """The whole page; `contents` [(id, words)] is its list of contents."""
    nav = "".join(f"<li>{link(name, words)}</li>" for name, words in contents)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>{text(title)}</title>\n<style>{STYLE}</style></head>\n<body>\n<h1>{text(title)}</h1>\n<nav><ul>{nav}</ul></nav>\n{body}\n"
            "</body></html>\n")  # fmt: skip
