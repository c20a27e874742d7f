# Chapter 6 of the thesis again (docs/report): at most 20 minutes on two cores; QUICK=1, a quarter of the walks, five.
QUICK :=
REPORT := $(BUILD)/report
.PHONY: report
report: core ## Run chapter 6 of the thesis, ablations, robustness and recovery: writes docs/report (QUICK=1: five minutes)
	@rm -rf $(REPORT)
	@$(BUILD)/bin/echoway_report --out $(REPORT) --threads $(JOBS) $(if $(QUICK),--quick)
	@$(PYTHON) scripts/report --tables $(REPORT) --out docs/report --echoway $(ECHOWAY) $(if $(QUICK),--quick)
	@echo "docs/report/README.md"
