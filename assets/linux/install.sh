#!/bin/sh
# Installs Pinhole for one user, or for all: ./install.sh [PREFIX], ~/.local unless it is given.
# From an unpacked archive it brings the program; from the sources, what cargo install leaves out:
# desktop file, icon, man pages and completions. ./install.sh --remove [PREFIX] takes all away.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
remove=false
if [ "${1-}" = --remove ]; then remove=true; shift; fi
prefix=${1-$HOME/.local}

put() { # put FILE TARGET MODE
  if $remove; then rm -f "$prefix/$2"; else install -D -m "$3" "$1" "$prefix/$2"; fi
}

if [ -e "$here/pinhole" ]; then
  assets=$here
  put "$here/pinhole" bin/pinhole 755
else
  assets=$(dirname "$here")
fi
put "$here/pinhole.desktop" share/applications/pinhole.desktop 644
put "$assets/icon.png" share/icons/hicolor/128x128/apps/pinhole.png 644
for page in "$assets"/man/*.1; do
  put "$page" "share/man/man1/$(basename "$page")" 644
done
put "$assets/completions/pinhole.bash" share/bash-completion/completions/pinhole 644
put "$assets/completions/_pinhole" share/zsh/site-functions/_pinhole 644
put "$assets/completions/pinhole.fish" share/fish/vendor_completions.d/pinhole.fish 644

if $remove; then echo "removed from $prefix"; exit; fi
echo "installed to $prefix"
case ":$PATH:" in *":$prefix/bin:"*) ;; *) echo "$prefix/bin is not in PATH: add it to start pinhole by name" ;; esac
