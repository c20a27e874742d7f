"""How every picture of the report looks."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator  # noqa: E402

FEET = 0.3048
DPI = 110

# Colours that stay apart for colour-blind readers (Okabe and Ito).
METHODS = {
    "thesis by objective": {"color": "#cc79a7", "label": "thesis's method, rooms by objective"},
    "thesis as printed": {"color": "#e69f00", "label": "thesis's method, (5.1) as printed"},
    "thesis": {"color": "#d55e00", "label": "thesis's method"},
    "tracker without hints": {"color": "#56b4e9", "label": "tracker, echoes alone"},
    "tracker": {"color": "#0072b2", "label": "tracker, with steps and gyroscope"},
}
COMPARED = ("thesis as printed", "thesis", "tracker without hints", "tracker")
PUBLISHED = {"color": "black", "label": "the thesis's own figure"}
NAMES = {method: look["label"] for method, look in METHODS.items()}

plt.rcParams.update({
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.7,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "lines.linewidth": 1.6,
    "figure.constrained_layout.use": True,
})


def plain_log(axis):
    """A logarithmic axis with numbers as people write them."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_locator(NullLocator())


def legend_below(figure, axes, columns):
    """One legend for all panels, below them, of what `axes` shows."""
    figure.legend(*axes.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=columns)


def save(figure, out, name, alt):
    """Writes the picture; the Markdown that shows it."""
    figure.savefig(out / f"{name}.png", dpi=DPI, bbox_inches="tight")
    plt.close(figure)
    return f"![{alt}]({name}.png)"


def table(heads, rows, right=True):
    """A Markdown table; cells are text."""
    mark = "--:" if right else "---"
    lines = ["| " + " | ".join(heads) + " |", "|---" + f"|{mark}" * (len(heads) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])
