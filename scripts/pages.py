"""Pages of which a run writes a part: what stands between two marker lines."""


def put(page, name, target, lines):
    """The text of `page` with `lines` as its part `name`, which `make TARGET` writes."""
    begin, end = f"<!-- {name}: make {target} -->", f"<!-- end of {name} -->"
    before, rest = page.split(begin)
    return before + "\n".join([begin, *lines, end]) + rest.split(end)[1]
