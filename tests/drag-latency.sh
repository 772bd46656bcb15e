#!/usr/bin/env bash
# Measures how long the window takes from the mouse's move to the presented picture: the camera looks
# round under the hand (right button, in the camera view) in a real window of this size.
#
#     tests/drag-latency.sh [WIDTHxHEIGHT [SCENE...]]
#
# Takes PINHOLE_BINARY, or the release build; what else it needs is in support/display.sh. A line for
# each scene, layout and renderer, with medians in milliseconds of the frames that answer a move:
# from the input to the presented picture, and of this: waiting for the display; the program's pass;
# of the pass: tracing, overlay, readouts, and their sum; and painting, with what it uploads.
set -euo pipefail
size=${1:-1920x1080}
shift || true
scenes=("${@:-canonical}")
program=${PINHOLE_BINARY:-$(dirname "$0")/../target/release/pinhole}
. "$(dirname "$0")/support/display.sh"
start_display "$size"
width=${size%x*} height=${size#*x}

# Moves the mouse in the right half of the window, where the camera view is in every layout here but
# the derivation's. One process does it all: one for each move would end, and the next begin, on the
# cores that the frame needs.
drag() {
  local x=$1 y=$2 k
  local -a moves=()
  for ((k = 1; k <= 150; k++)); do
    moves+=(mousemove $((x + k)) $((y + k % 7)) sleep 0.025)
  done
  xdotool mousemove "$x" "$y" mousedown 3 sleep 0.3 "${moves[@]}" mouseup 3 sleep 0.5
}

# The median of a column of the frames that answer a move with a new picture; `since_input` and `own`
# are empty in the others.
median() {
  awk -F, -v name="$1" '
    NR == 1 { for (k = 1; k <= NF; k++) { at[$k] = k } column = at[name]; own = at["own"]; next }
    $1 != "" && $own != "" { print $column }' "$work/frames.csv" | sort -n |
    awk '{ value[NR] = $1 } END { if (NR < 20) exit 1; printf "%7.2f", value[int((NR + 1) / 2)] }'
}

printf '%-16s %-8s %-8s %7s %7s %7s %7s %7s %7s %7s %7s\n' \
  scene layout renderer input wait ui trace overlay readout own paint
export PINHOLE_FRAME_TIMES=
for scene in "${scenes[@]}"; do
  for layout in Both Derivation; do
    for renderer in cpu wgpu; do
      PINHOLE_FRAME_TIMES=$work/frames.csv
      rm -f "$work/frames.csv"
      open_window "$program" "{\"layout\": \"$layout\"}" "$scene" --renderer "$renderer"
      x=$((width * 75 / 100)) y=$((height * 45 / 100))
      [ "$layout" = Derivation ] && x=$((width * 36 / 100)) y=$((height * 80 / 100))
      DISPLAY=$display drag "$x" "$y"
      # The log is written when the window is closed, which asks about changes if there are any.
      DISPLAY=$display xdotool key ctrl+z
      sleep 0.5
      DISPLAY=$display xdotool key ctrl+q
      wait "$process" || true
      printf '%-16s %-8s %-8s' "$(basename "$scene")" "$layout" "$renderer"
      for name in since_input wait ui trace overlay readouts own paint; do
        if ! value=$(median "$name"); then
          echo "too few frames answered a move: is the window covered, or was it not closed?" >&2
          exit 1
        fi
        printf ' %s' "$value"
      done
      echo
    done
  done
done
