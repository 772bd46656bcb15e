#!/usr/bin/env bash
# Measures how long the window takes from the mouse's move to the presented picture: the camera looks
# round under the hand (right button, in the camera view) in a real window of this size.
#
#     tests/drag-latency.sh [WIDTHxHEIGHT [SCENE...]]
#
# Takes PINHOLE_BINARY, or the release build; what else it needs is in support/display.sh. A line for
# each scene, layout and renderer: medians in milliseconds of the frames that answer a move.
set -euo pipefail
size=${1:-1920x1080}
shift || true
scenes=("${@:-canonical}")
program=${PINHOLE_BINARY:-$(dirname "$0")/../target/release/pinhole}
. "$(dirname "$0")/support/display.sh"
start_display "$size"
width=${size%x*} height=${size#*x}

# Moves the mouse in the right half of the window, where the camera view is in every layout here but
# the ledger's.
drag() {
  local x=$1 y=$2 k
  xdotool mousemove "$x" "$y" mousedown 3
  sleep 0.3
  for ((k = 1; k <= 150; k++)); do
    xdotool mousemove $((x + k)) $((y + k % 7))
    sleep 0.025
  done
  xdotool mouseup 3
  sleep 0.5
}

# The median of a column of the frames that answer a move; `since_input` is empty in the others.
median() {
  awk -F, -v name="$1" '
    NR == 1 { for (k = 1; k <= NF; k++) if ($k == name) column = k; next }
    $1 != "" { print $column }' "$work/frames.csv" | sort -n |
    awk '{ value[NR] = $1 } END { printf "%7.2f", value[int((NR + 1) / 2)] }'
}

printf '%-16s %-8s %-8s %7s %7s %7s %7s %7s %7s\n' \
  scene layout renderer input frame ui upload paint wait
export PINHOLE_FRAME_TIMES=
for scene in "${scenes[@]}"; do
  for layout in Both Ledger; do
    for renderer in cpu wgpu; do
      PINHOLE_FRAME_TIMES=$work/frames.csv
      open_window "$program" "{\"layout\": \"$layout\"}" "$scene" --renderer "$renderer"
      x=$((width * 75 / 100)) y=$((height * 45 / 100))
      [ "$layout" = Ledger ] && x=$((width * 36 / 100)) y=$((height * 80 / 100))
      DISPLAY=$display drag "$x" "$y"
      # The log is written when the window is closed, which asks about changes if there are any.
      DISPLAY=$display xdotool key ctrl+z
      sleep 0.5
      DISPLAY=$display xdotool key ctrl+q
      wait "$process" || true
      printf '%-16s %-8s %-8s' "$scene" "$layout" "$renderer"
      for name in since_input frame ui upload paint wait; do printf ' %s' "$(median "$name")"; done
      echo
    done
  done
done
