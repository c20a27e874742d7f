# The proof of guidance (docs/guidance.md): takes some minutes.
.PHONY: guidance-proof
guidance-proof: core ## Blindfolded wearers walk by cues alone: writes docs/guidance-proof.md and .png
	@rm -rf $(BUILD)/guidance-proof
	@scripts/guidance_proof.sh $(BUILD)/bin/guidance_proof $(BUILD)/guidance-proof
	@$(PYTHON) scripts/plot_guidance_proof.py $(BUILD)/guidance-proof/guidance-proof.csv \
	  $(BUILD)/guidance-proof/guidance-traces.csv docs
