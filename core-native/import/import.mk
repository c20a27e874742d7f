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
