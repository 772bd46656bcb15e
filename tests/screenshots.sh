#!/usr/bin/env bash
# Takes the README's pictures of the real window anew, into assets/screenshots.
# Builds the release binary first; what else it needs is in support/display.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/display.sh
cargo build --locked --release
out=$PWD/assets/screenshots
mkdir -p "$out"
start_display 1280x800
export DISPLAY=$display

# shot NAME SCENE|--lesson=N SETTINGS [SECONDS]: the window without its frame, on the whole screen.
shot() {
  open_window target/release/pinhole "$3" "$2"
  xdotool mousemove 1279 799
  sleep "${4:-2}"
  import -window "$window" "$out/$1.png"
  close_window
}

shot canonical canonical '{}'
shot lesson-7 --lesson=7.3 '{}'
# Measuring takes its time.
shot accuracy planet '{"layout": "Accuracy"}' 20
