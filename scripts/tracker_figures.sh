#!/usr/bin/env bash
# Measures the tracker on the walks that docs/tracker.md shows; one row a walk: tracker_figures.sh BINARY waves|rays OUT.csv
# Their seeds are apart from those on which the tracker was tuned.
set -eu
binary=$1 world=$2 out=$3
mkdir -p "$(dirname "$out")"
"$binary" --head > "$out"
offices() { "$binary" --world "$world" --first 1200 --walks 48 --seconds 80 "$@" >> "$out"; }
map() { local name=$1; shift; "$binary" --world "$world" --building "maps/$name" --first 900 --walks 40 --seconds 90 "$@" >> "$out"; }
for hints in "" --no-hints; do
  for start in "" --unknown; do
    offices $start $hints
    for name in torgersen-lab similar-rooms two-rooms sample-room; do
      # Of three rooms alike nobody can say which one a wearer of unknown start is in.
      if [ "$start$name" != --unknownsimilar-rooms ]; then map $name $start $hints; fi
    done
    # Rays know no other levels.
    if [ "$world$start$hints" = waves--unknown ]; then
      "$binary" --building maps/westport-house --first 900 --walks 24 --seconds 60 $start >> "$out"
    fi
  done
done
