#!/bin/sh
# From an unpacked archive it brings the program; from the sources, what cargo install leaves out:
# desktop entry, icon, man pages and completions.
set -eu
usage='usage: install.sh [--remove] [PREFIX]

Installs Pinhole under PREFIX, ~/.local unless it is given: for all users, sudo ./install.sh /usr/local.
  --remove  take away what was installed under PREFIX
  --help    show this'

refuse() { printf 'install.sh: %s\n%s\n' "$1" "$usage" >&2; exit 2; }

remove=false prefix=
for argument; do
  case $argument in
    --remove) remove=true ;;
    -h | --help) printf '%s\n' "$usage"; exit ;;
    -*) refuse "there is no option $argument" ;;
    '') refuse "PREFIX is empty" ;;
    *) [ -z "$prefix" ] || refuse "there is one PREFIX, not $prefix and $argument"; prefix=$argument ;;
  esac
done
prefix=${prefix:-${HOME:?is not set: give a PREFIX}/.local}
case $prefix in
  /*) ;;
  *) prefix=$PWD/$prefix ;;
esac
case $prefix in
  *=* | *[[:cntrl:]]*) refuse "a desktop entry cannot name a program in $prefix" ;;
esac
here=$(CDPATH= cd "$(dirname "$0")" && pwd)
if [ -e "$here/pinhole" ]; then assets=$here; else assets=$(dirname "$here"); fi

$remove || mkdir -p "$prefix"
if [ -d "$prefix" ]; then prefix=$(cd "$prefix" && pwd); fi
prefix=${prefix%/}

# Takes away the folder of a file, and those around it up to PREFIX, where nothing else is in them.
tidy() {
  folder=${1%/*}
  while [ "${folder#"$prefix"}" != "$folder" ] && rmdir "$folder" 2>/dev/null; do
    folder=${folder%/*}
  done
}

put() { # put FILE TARGET MODE
  if $remove; then
    rm -f "$prefix/$2"
    tidy "$prefix/$2"
  else
    install -D -m "$3" "$1" "$prefix/$2"
  fi
}

# Where the program is that the desktop entry starts.
program() {
  if [ -e "$prefix/bin/pinhole" ]; then
    printf '%s' "$prefix/bin/pinhole"
  elif ! command -v pinhole; then
    printf '%s' "${CARGO_HOME:-$HOME/.cargo}/bin/pinhole"
  fi
}

# Desktop entries escape twice: what is special between quotes, and then every backslash.
quoted() {
  case $1 in
    *[!A-Za-z0-9/._+:@-]*) printf '%s' "$1" | sed 's/["`$\\]/\\&/g; s/\\/\\\\/g; s/%/%%/g; s/.*/"&"/' ;;
    *) printf '%s' "$1" ;;
  esac
}
plain() { printf '%s' "$1" | sed 's/\\/\\\\/g'; }
replacement() { printf '%s' "$1" | sed 's/[\\&|]/\\&/g'; }

put_desktop_entry() {
  entry=share/applications/pinhole.desktop
  put "$here/pinhole.desktop" "$entry" 644
  if $remove; then return; fi
  started=$(program)
  icon=pinhole
  if ! $is_seen; then icon=$prefix/$icon_file; fi
  sed -e "s|^Exec=.*|Exec=$(replacement "$(quoted "$started")") %f|" \
    -e "s|^TryExec=.*|TryExec=$(replacement "$(plain "$started")")|" \
    -e "s|^Icon=.*|Icon=$(replacement "$(plain "$icon")")|" "$here/pinhole.desktop" >"$prefix/$entry"
}

# What desktops look up by, made anew; where nothing but it is left, it goes too.
update() {
  applications=$prefix/share/applications
  if [ -z "$(find "$applications" ! -type d ! -name mimeinfo.cache 2>/dev/null)" ]; then
    rm -f "$applications/mimeinfo.cache"
    tidy "$applications/mimeinfo.cache"
  elif command -v update-desktop-database >/dev/null; then
    update-desktop-database -q "$applications"
  fi
}

# Whether desktops look into this prefix at all.
is_seen=false
case ":${XDG_DATA_HOME:-${HOME-}/.local/share}:${XDG_DATA_DIRS:-/usr/local/share:/usr/share}:" in
  *":$prefix/share:"* | *":$prefix/share/:"*) is_seen=true ;;
esac

if [ "$assets" = "$here" ]; then put "$here/pinhole" bin/pinhole 755; fi
for page in "$here/pinhole.html" "$assets/target/pinhole.html"; do
  if $remove || [ -e "$page" ]; then put "$page" share/pinhole/pinhole.html 644; fi
done
icon_file=share/icons/hicolor/256x256/apps/pinhole.png
put "$assets/icon.png" "$icon_file" 644
put_desktop_entry
for page in "$assets"/man/*.1; do
  put "$page" "share/man/man1/$(basename "$page")" 644
done
put "$assets/completions/pinhole.bash" share/bash-completion/completions/pinhole 644
put "$assets/completions/_pinhole" share/zsh/site-functions/_pinhole 644
put "$assets/completions/pinhole.fish" share/fish/vendor_completions.d/pinhole.fish 644
update

if $remove; then echo "removed from $prefix"; exit; fi
echo "installed to $prefix"
case ":$PATH:" in
  *":$prefix/bin:"*) ;;
  *) echo "$prefix/bin is not in PATH: add it to start pinhole by name" ;;
esac
$is_seen || echo "$prefix/share is not in XDG_DATA_DIRS: add it to see Pinhole among the desktop's programs"
