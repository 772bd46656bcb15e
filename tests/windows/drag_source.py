"""A window from which a file can be dragged into another one, by X's drag and drop: drag_source.py FILE.

    apt-get install python3-gi gir1.2-gtk-3.0
"""
import pathlib
import sys

import gi

gi.require_version("Gdk", "3.0")
gi.require_version("Gtk", "3.0")
from gi.repository import Gdk, Gtk  # noqa: E402

uri = pathlib.Path(sys.argv[1]).as_uri()
window = Gtk.Window(title="drag source")
window.set_default_size(100, 100)
window.drag_source_set(Gdk.ModifierType.BUTTON1_MASK, [], Gdk.DragAction.COPY)
window.drag_source_add_uri_targets()
window.connect("drag-data-get", lambda _window, _context, data, _info, _time: data.set_uris([uri]))
window.connect("drag-end", lambda *_: Gtk.main_quit())
window.show_all()
Gtk.main()
