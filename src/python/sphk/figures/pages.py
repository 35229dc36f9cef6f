# SPDX-License-Identifier: BSD-3-Clause
"""Pages that need nothing beside them, by Jinja's templates: they read well on a screen, small or dark, and printed."""

import base64
import os

from .style import tell


def image(file, caption):
    """An <img> with the whole PNG in it."""
    from markupsafe import Markup

    with open(file, "rb") as png:
        data = base64.b64encode(png.read()).decode()
    return Markup('<img alt="{}" src="data:image/png;base64,{}">').format(caption, data)


def page_of(work):
    """The text of the page that the template `work["page"]` makes of the work order."""
    import jinja2  # of all that is drawn here pages alone need it

    templates = jinja2.Environment(loader=jinja2.FileSystemLoader(os.path.join(os.path.dirname(__file__), "templates")),
                                   autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    templates.filters["image"] = image
    return templates.get_template(work["page"]).render(work) + "\n"


def write_page(work):
    beside = work["out"] + ".new"
    with open(beside, "w", encoding="utf-8") as file:
        file.write(page_of(work))
    os.replace(beside, work["out"])
    tell(work["out"])
