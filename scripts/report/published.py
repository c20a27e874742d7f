"""What the thesis itself reports, in feet (tables 6.1 and 6.2, and its text)."""

# Room: mean and standard deviation of the location error over three sets of ten places.
TABLE_6_1 = {"1": (0.51, 0.40), "4": (0.41, 0.31), "5": (1.15, 1.02), "3": (0.91, 0.47), "6": (2.71, 2.95), "hall": (2.63, 1.24)}
TABLE_6_2_NEW = {"3": (0.61, 0.52), "6": (1.40, 0.94)}  # With the benches as all-reflective elements.
EQUAL_WEIGHTS = 2.91    # Checkpoint two of the circular walk, equal weights,
UNEQUAL_WEIGHTS = 0.5   # and two to one.
EQUAL_TO_UNEQUAL = 6.0  # "Almost six times larger" at checkpoints two and nine.
TURN_WITH_15 = 25.0     # Degrees: "bounded within 25 degrees".
ROOM_4_BOUND = 1.5      # Figure 6.17 between checkpoints 15 and 24.
SECONDS_A_MATCH = 40.0
