#!/usr/bin/env bash
# Runs the proof of guidance; one row a walk goes to OUT_DIR/guidance-proof.csv: guidance_proof.sh BINARY OUT_DIR
set -eu
binary=$1 out=$2
rows=$out/guidance-proof.csv traces=$out/guidance-traces.csv
mkdir -p "$out"
rm -f "$rows" "$traces"
maps=(maps/*/)
maps=("${maps[@]%/}")
"$binary" "$rows" "$traces" 200 noise "${maps[@]}" office grid levels
cluttered=(maps/similar-rooms maps/torgersen-lab maps/two-rooms office)
"$binary" "$rows" "$traces" 100 obstacles "${cluttered[@]}"
# Westport House is left out below: its many walls make the simulated echoes slow.
small=(maps/sample-room maps/similar-rooms maps/torgersen-lab maps/two-rooms office)
"$binary" "$rows" "$traces" 40 empty "${small[@]}"
# Each office is another building, and what stands in it decides: fewer walks say little.
"$binary" "$rows" "$traces" 40 furnished "${small[@]::4}"
"$binary" "$rows" "$traces" 120 furnished office
"$binary" "$rows" "$traces" 40 furnished levels
"$binary" "$rows" "$traces" 40 cluttered "${cluttered[@]::3}"
"$binary" "$rows" "$traces" 120 cluttered office
"$binary" "$rows" "$traces" 40 search maps/torgersen-lab
