# Chapter 6 of the thesis again (docs/report). QUICK=1 takes a quarter of the walks.
QUICK :=
REPORT := $(BUILD)/report
.PHONY: report
report: core ## Run chapter 6 of the thesis, ablations, robustness and recovery: writes docs/report (20 minutes on two cores; QUICK=1: five)
	@rm -rf $(REPORT)
	@$(BUILD)/bin/echoway_report --out $(REPORT) --threads $(JOBS) $(if $(QUICK),--quick)
	@$(PYTHON) scripts/report --tables $(REPORT) --out docs/report --echoway $(ECHOWAY) $(if $(QUICK),--quick)
	@echo "docs/report/README.md"
