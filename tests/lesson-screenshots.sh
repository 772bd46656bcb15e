#!/usr/bin/env bash
# Takes a picture of every step of every lesson into FOLDER, to be looked at, as LESSON.STEP.png.
#
#     tests/lesson-screenshots.sh FOLDER [WIDTHxHEIGHT [SETTINGS]]
#     tests/lesson-screenshots.sh /tmp/large 1920x1080 '{"zoom": 1.5}'
#
# Needs Xvfb, openbox, xdotool and ImageMagick, and a binary: PINHOLE_BINARY, or the debug build.
set -euo pipefail
out=$1 size=${2:-1280x720} settings=${3:-"{}"}
program=${PINHOLE_BINARY:-$(dirname "$0")/../target/debug/pinhole}
work=$(mktemp -d)
mkdir -p "$out"

exec {display_pipe}<> <(:)
Xvfb -displayfd "$display_pipe" -screen 0 "${size}x24" -nolisten tcp -noreset 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null; rm -rf "$work"' EXIT
read -r number <&"$display_pipe"
export WINIT_X11_SCALE_FACTOR=1 XDG_STATE_HOME=$work
unset WAYLAND_DISPLAY DISPLAY
DISPLAY=:$number openbox 2>/dev/null &
until DISPLAY=:$number xdotool get_num_desktops >/dev/null 2>&1; do sleep 0.1; done

# Without a display a step that is there ends with status 1, one that is not with 2.
is_there() { "$program" --lesson "$1" 2>/dev/null || [ $? = 1 ]; }

shot() {
  mkdir -p "$work/pinhole"
  printf '{"settings": %s, "window": {"maximized": true}}' "$settings" >"$work/pinhole/state.json"
  local -x DISPLAY=:$number
  "$program" --lesson "$1" 2>/dev/null &
  local window=$!
  until xdotool search --onlyvisible --name ' - Pinhole' >/dev/null 2>&1; do sleep 0.1; done
  xdotool mousemove "${size%x*}" "${size#*x}"
  sleep 1.3
  import -window root "$out/$1.png"
  kill "$window"
  wait "$window" 2>/dev/null || true
}

for ((lesson = 1; ; lesson++)); do
  is_there "$lesson" || break
  for ((step = 1; ; step++)); do
    is_there "$lesson.$step" || break
    shot "$lesson.$step"
  done
done
