#!/usr/bin/env bash
# Runs the proof of guidance; one row a walk goes to OUT_DIR/guidance-proof.csv: guidance_proof.sh BINARY OUT_DIR
set -eu
binary=$1 out=$2
rows=$out/guidance-proof.csv traces=$out/guidance-traces.csv
mkdir -p "$out"
echo "map,source,walk,arrived,time_s,walked_m,shortest_m,touches,wrong,instructions,cues,end_error_m,track_error_m,room_right,bumps,wrong_place,leading,barred" > "$rows"
echo "map,source,walk,kind,x_m,y_m,level,text" > "$traces"
maps=(maps/*/)
maps=("${maps[@]%/}")
"$binary" "$rows" "$traces" 200 noise "${maps[@]}" office grid levels
cluttered=(maps/similar-rooms maps/torgersen-lab maps/two-rooms office)
"$binary" "$rows" "$traces" 100 obstacles "${cluttered[@]}"
# Westport House is left out below: its many walls make the simulated echoes slow.
small=(maps/sample-room maps/similar-rooms maps/torgersen-lab maps/two-rooms office)
"$binary" "$rows" "$traces" 40 empty "${small[@]}"
"$binary" "$rows" "$traces" 40 furnished "${small[@]}" levels
"$binary" "$rows" "$traces" 40 cluttered "${cluttered[@]}"
"$binary" "$rows" "$traces" 40 search maps/torgersen-lab
