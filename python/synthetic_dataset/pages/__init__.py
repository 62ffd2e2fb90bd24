"""The shared parts of pages for a browser. Each page is one file with its pictures inside and loads nothing."""
import base64
import html
import io
import os
import pathlib

import jinja2

from synthetic_dataset.manifest import DatasetError

HERE = pathlib.Path(__file__).parent


def rendered(folder, **values):
    """The folder's page.html with values, as HTML; its page.css, where there is one, comes after base.css."""
    loader = jinja2.FileSystemLoader([str(folder), str(HERE)])
    environment = jinja2.Environment(loader=loader, autoescape=True, trim_blocks=True, lstrip_blocks=True,
                                     undefined=jinja2.StrictUndefined)
    environment.filters['thousands'] = '{:,}'.format
    environment.filters['with_code'] = _with_code
    styles = [file.read_text('utf-8') for file in (HERE / 'base.css', folder / 'page.css') if file.exists()]
    return environment.get_template('page.html').render(style=''.join(styles), **values)


def _with_code(text):
    """Shows text in backquotes as code."""
    parts = [html.escape(part) for part in text.split('`')]
    return ''.join(f'<code>{part}</code>' if place % 2 else part for place, part in enumerate(parts))


def embedded(picture, kind='jpeg'):
    """A picture as the URL of an image of a page."""
    content = io.BytesIO()
    picture.save(content, format=kind.upper(), **({'quality': 82} if kind == 'jpeg' else {}))
    return f'data:image/{kind};base64,' + base64.b64encode(content.getvalue()).decode('ascii')


def write(page, file):
    """Writes a page. The file is there when it is whole.

    @throws DatasetError where it cannot be written
    """
    target = pathlib.Path(file).resolve()
    # Beside it, as a name is moved within one file system alone; verify passes over this name.
    temporary = target.with_name(f'.{target.name}.tmp')
    try:
        temporary.write_text(page, 'utf-8')
        os.replace(temporary, target)
    except OSError as error:
        raise DatasetError(f"'{file}': cannot be written: {error.strerror}") from error
