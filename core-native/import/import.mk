# Buildings made from venue plans. Included by the top Makefile.
WESTPORT := maps/westport-house

.PHONY: westport-house
westport-house: core ## Make maps/westport-house from the plan in its source folder
	@rm -f $(WESTPORT)/room-*.room $(WESTPORT)/building.cfg
	@$(ECHOWAY) import wrld $(WESTPORT)/source --out $(WESTPORT) --report $(WESTPORT)/import-report.txt | tail -n 4
	@$(ECHOWAY) check $(WESTPORT)

.PHONY: westport-pictures
westport-pictures: westport-house ## Draw every level of Westport House into build/plots
	@$(PYTHON) scripts/draw_building.py $(WESTPORT) --out $(BUILD)/plots

LEVELS := $(BUILD)/demo-levels

.PHONY: levels-walk
levels-walk: core
	@mkdir -p $(LEVELS)
	@echo "A wearer walks from the street up two flights of stairs to an office on the second floor of Westport House."
	@$(ECHOWAY) simulate --building $(WESTPORT) --walk $(WESTPORT)/walks/three-levels.walk --out $(LEVELS)/walk > $(LEVELS)/walk.txt
	@$(ECHOWAY) locate --building $(WESTPORT) --scans $(LEVELS)/walk.scans.csv --motion $(LEVELS)/walk.motion.csv \
	    --start g-vestibule,4.2,4.2,-90 --to "WRLD Office" --track $(LEVELS)/tracker.track.csv --cues $(LEVELS)/cues.csv \
	    > $(LEVELS)/locate.txt

.PHONY: demo-levels
demo-levels: levels-walk ## A walk from the street up two storeys of Westport House: what the wearer hears, the error, a picture
	@echo "They hear:"
	@cat $(LEVELS)/walk.txt $(LEVELS)/locate.txt
	@echo "The tracker against the truth (on stairs, the nearer end of the flight):"
	@$(ECHOWAY) score --building $(WESTPORT) --track $(LEVELS)/tracker.track.csv --truth $(LEVELS)/walk.truth.csv
	@$(PYTHON) scripts/plot_track.py --echoway $(ECHOWAY) --building $(WESTPORT) --truth $(LEVELS)/walk.truth.csv \
	    --track $(LEVELS)/tracker.track.csv --out $(LEVELS)/walk.png
	@echo "Picture: $(LEVELS)/walk.png"

.PHONY: levels-summary
levels-summary: levels-walk
	@echo "The way up, as they hear it (all of it: make demo-levels):"
	@awk -F, '$$2 ~ /^(destination|entering|take_link|arrived)$$/ { time = $$1; sub(/^[^,]*,[^,]*,/, ""); gsub(/"/, ""); \
	    printf "%8.2f s  %s\n", time, $$0 }' $(LEVELS)/cues.csv
	@echo "The tracker against the truth (on stairs, the nearer end of the flight):"
	@$(ECHOWAY) score --building $(WESTPORT) --track $(LEVELS)/tracker.track.csv --truth $(LEVELS)/walk.truth.csv
