#!/usr/bin/env bash
# Takes a picture of every step of every lesson, or of those that are named, into FOLDER, to be looked
# at, as LESSON.STEP.png.
#
#     tests/lesson-screenshots.sh FOLDER [WIDTHxHEIGHT [SETTINGS [LESSON.STEP...]]]
#     tests/lesson-screenshots.sh /tmp/large 1920x1080 '{"zoom": 1.5}'
#     tests/lesson-screenshots.sh /tmp/some 1280x720 '{}' 7.3 12.2
#     PRESENT=1 tests/lesson-screenshots.sh /tmp/hall 1920x1080    in presenter mode
#     STATES=1 tests/lesson-screenshots.sh /tmp/states 1920x1080 '{}' 7 12
#                                         the named lessons, or all, presented: a picture of each
#                                         question, revealed line and answer, as LESSON.STEP.STATE.png
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

# Pages through a lesson as a lecturer does. The window's title has the number of the step.
states() {
  open_window "$program" "$settings" --lesson "$1"
  local -x DISPLAY=$display
  local step=0 state=0 now
  xdotool mousemove "${size%x*}" "${size#*x}"
  xdotool windowfocus --sync "$window" key F5
  sleep 1.3
  while :; do
    now=$(xdotool getwindowname "$window" | grep -oP 'step \K\d+' || true)
    # After the last step comes the next lesson.
    [ -n "$now" ] && ((now >= step)) || break
    ((now == step)) && ((++state)) || state=1
    step=$now
    import -window root "$out/$1.$step.$state.png"
    xdotool key Next
    sleep 0.9
    # After the last step nothing comes.
    import -window root "$work/next.png"
    ! cmp -s "$work/next.png" "$out/$1.$step.$state.png" || break
  done
  close_window
}

if [ -n "${STATES:-}" ]; then
  [ ${#named[@]} != 0 ] || for ((k = 1; ; k++)); do is_there "$k" && named+=("$k") || break; done
  for lesson in "${named[@]}"; do states "$lesson"; done
  exit 0
fi
for step in "${named[@]}"; do shot "$step"; done
[ ${#named[@]} = 0 ] || exit 0
for ((lesson = 1; ; lesson++)); do
  is_there "$lesson" || break
  for ((step = 1; ; step++)); do
    is_there "$lesson.$step" || break
    shot "$lesson.$step"
  done
done
