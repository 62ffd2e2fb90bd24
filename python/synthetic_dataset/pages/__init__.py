"""Shared parts of the HTML pages. Each page is a single file that contains its pictures and loads nothing."""
import base64
import html
import io
import os
import pathlib

import jinja2

from synthetic_dataset.manifest import DatasetError

HERE = pathlib.Path(__file__).parent


def rendered(folder, **values):
    """The folder's page.html rendered with values; its page.css, if there is one, comes after base.css."""
    loader = jinja2.FileSystemLoader([str(folder), str(HERE)])
    environment = jinja2.Environment(loader=loader, autoescape=True, trim_blocks=True, lstrip_blocks=True,
                                     undefined=jinja2.StrictUndefined)
    environment.filters['thousands'] = '{:,}'.format
    environment.filters['with_code'] = _with_code
    styles = [file.read_text('utf-8') for file in (HERE / 'base.css', folder / 'page.css') if file.exists()]
    return environment.get_template('page.html').render(style=''.join(styles), **values)


def _with_code(text):
    """The text as HTML, with parts in backquotes as code."""
    parts = [html.escape(part) for part in text.split('`')]
    return ''.join(f'<code>{part}</code>' if place % 2 else part for place, part in enumerate(parts))


def embedded(picture, kind='jpeg'):
    """A picture as a data URL for an image in a page."""
    content = io.BytesIO()
    picture.save(content, format=kind.upper(), **({'quality': 82} if kind == 'jpeg' else {}))
    return f'data:image/{kind};base64,' + base64.b64encode(content.getvalue()).decode('ascii')


def write(page, file):
    """Writes a page. The file appears only when it is complete.

    @throws DatasetError if it cannot be written
    """
    target = pathlib.Path(file).resolve()
    # In the same folder, as files can only be renamed within a file system; verify ignores this name.
    temporary = target.with_name(f'.{target.name}.tmp')
    try:
        temporary.write_text(page, 'utf-8')
        os.replace(temporary, target)
    except OSError as error:
        raise DatasetError(f"'{file}': cannot be written: {error.strerror}") from error
