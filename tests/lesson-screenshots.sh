#!/usr/bin/env bash
# Takes a picture of every step of every lesson, or of those that are named, into FOLDER, to be looked
# at, as LESSON.STEP.png.
#
#     tests/lesson-screenshots.sh FOLDER [WIDTHxHEIGHT [SETTINGS [LESSON.STEP...]]]
#     tests/lesson-screenshots.sh /tmp/large 1920x1080 '{"zoom": 1.5}'
#     tests/lesson-screenshots.sh /tmp/some 1280x720 '{}' 7.3 12.2
#     PRESENT=1 tests/lesson-screenshots.sh /tmp/hall 1920x1080    in presenter mode
#
# Takes PINHOLE_BINARY, or the debug build; what else it needs is in support/display.sh.
set -euo pipefail
out=$1 size=${2:-1280x720} settings=${3:-"{}"} named=("${@:4}")
program=${PINHOLE_BINARY:-$(dirname "$0")/../target/debug/pinhole}
. "$(dirname "$0")/support/display.sh"
mkdir -p "$out"
start_display "$size"

# Without a display a step that is there ends with status 1, one that is not with 2.
is_there() { "$program" --lesson "$1" 2>/dev/null || [ $? = 1 ]; }

shot() {
  open_window "$program" "$settings" --lesson "$1"
  local -x DISPLAY=$display
  xdotool mousemove "${size%x*}" "${size#*x}"
  [ -z "${PRESENT:-}" ] || xdotool windowfocus --sync "$window" key F5
  sleep 1.3
  import -window root "$out/$1.png"
  close_window
}

for step in "${named[@]}"; do shot "$step"; done
[ ${#named[@]} = 0 ] || exit 0
for ((lesson = 1; ; lesson++)); do
  is_there "$lesson" || break
  for ((step = 1; ; step++)); do
    is_there "$lesson.$step" || break
    shot "$lesson.$step"
  done
done
