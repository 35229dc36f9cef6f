# SPDX-License-Identifier: BSD-3-Clause
"""Keys of scene files, and tables."""


def key_texts(given, settings=None):
    """Keys and values as the command line writes them: (name, text)."""
    keys = {**{name: value for name, value in given.items() if value is not None}, **(settings or {})}
    return [(name, _text(value)) for name, value in keys.items()]


def _text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(value.item() if hasattr(value, "item") else value)


def table(columns):
    """A DataFrame where pandas is installed, else the dict of arrays that it is given."""
    try:
        import pandas
    except ImportError:
        return columns
    return pandas.DataFrame(columns)
