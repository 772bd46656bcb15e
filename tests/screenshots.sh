#!/usr/bin/env bash
# Takes the README's pictures of the real window anew, into assets/screenshots.
# Needs Xvfb, openbox, xdotool and ImageMagick; builds the release binary first.
set -euo pipefail
cd "$(dirname "$0")/.."
cargo build --locked --release
out=$PWD/assets/screenshots
work=$(mktemp -d)
mkdir -p "$out"

exec {display_pipe}<> <(:)
Xvfb -displayfd "$display_pipe" -screen 0 1280x800x24 -nolisten tcp -noreset 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null; rm -rf "$work"' EXIT
read -r number <&"$display_pipe"
export DISPLAY=:$number WINIT_X11_SCALE_FACTOR=1 XDG_STATE_HOME=$work
unset WAYLAND_DISPLAY
openbox 2>/dev/null &
until xdotool get_num_desktops >/dev/null 2>&1; do sleep 0.1; done

# shot NAME SCENE|--lesson=N SETTINGS [SECONDS [ACTION]]: the window without its frame, on the whole
# screen, after an action of the mouse.
shot() {
  mkdir -p "$work/pinhole"
  printf '{"settings": %s, "window": {"maximized": true}}' "$3" >"$work/pinhole/state.json"
  target/release/pinhole "$2" 2>/dev/null &
  local program=$! window=
  until window=$(xdotool search --onlyvisible --name ' - Pinhole'); do sleep 0.1; done
  if [ $# -ge 5 ]; then sleep 2; "$5"; fi
  xdotool mousemove 1279 799
  sleep "${4:-2}"
  import -window "$window" "$out/$1.png"
  kill "$program"
  wait "$program" 2>/dev/null || true
}

# Orbits the world view, a step a frame.
orbit() {
  xdotool mousemove 480 320 mousedown 1
  for _ in {1..150}; do xdotool mousemove_relative -- 1 0; sleep 0.03; done
  xdotool mouseup 1
}

shot canonical canonical '{}'
shot look-at-light look-at '{"theme": "Light"}'
shot planet planet '{}'
# Measuring takes its time.
shot accuracy planet '{"layout": "Accuracy"}' 20
shot frame look-at '{"layout": "Frame"}' 2 orbit
shot lesson-7 --lesson=7.3 '{}'
shot lesson-11 --lesson=11.3 '{}'
shot lesson-12 --lesson=12.2 '{}'
