"""Writes a learning curve as SVG."""

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 720, 380, 60, 24, 20, 48
BLUE, GREY, ORANGE = "#1f5fa8", "#9aa4b0", "#c76b1a"


def ticks(limit):
    """Returns round numbers from 0 to `limit`, about six of them."""
    step = next(base * 10 ** power for power in range(-2, 6) for base in (1, 2, 5)
                if base * 10 ** power * 6 >= limit)
    return [i * step for i in range(int(limit / step) + 1)]


def write_curve(path, curve, shipped_mm_s):
    """Writes the best and the mean speed of each generation, and that of the shipped walk.

    `curve` has for each generation the seconds since the begin, the best and the mean speed.
    """
    end_s = max([1.0, *(point[0] for point in curve)])
    top = 1.1 * max([shipped_mm_s, *(point[1] for point in curve)])

    def x(seconds):
        return LEFT + (WIDTH - LEFT - RIGHT) * seconds / end_s

    def y(speed):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * max(0.0, speed) / top

    def line(column, colour, width):
        points = " ".join(f"{x(point[0]):.1f},{y(point[column]):.1f}" for point in curve)
        return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}"/>'

    def text(px, py, words, anchor="start", colour="#333"):
        return f'<text x="{px:.1f}" y="{py:.1f}" text-anchor="{anchor}" fill="{colour}">{words}</text>'

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="13"><rect width="100%" height="100%" fill="white"/>']
    for speed in ticks(top):
        parts.append(f'<path d="M{LEFT} {y(speed):.1f}H{WIDTH - RIGHT}" stroke="#e3e6ea"/>')
        parts.append(text(LEFT - 8, y(speed) + 4, f"{speed:g}", "end"))
    for seconds in ticks(end_s):
        parts.append(text(x(seconds), HEIGHT - BOTTOM + 18, f"{seconds:g}", "middle"))
    parts.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, "seconds of search", "middle"))
    parts.append(text(8, 16, "mm/s"))
    parts += [line(2, GREY, 1), line(1, BLUE, 2)]
    parts.append(f'<path d="M{LEFT} {y(shipped_mm_s):.1f}H{WIDTH - RIGHT}" stroke="{ORANGE}" '
                 'stroke-dasharray="6 4"/>')
    parts.append(text(WIDTH - RIGHT, y(shipped_mm_s) - 6, "walk of the stick", "end", ORANGE))
    if curve:
        parts.append(text(WIDTH - RIGHT, y(curve[-1][1]) - 8, "best of a generation", "end", BLUE))
        low = min(point[2] for point in curve[-(len(curve) // 4 + 1):])  # the lowest point above the words
        parts.append(text(WIDTH - RIGHT, y(low) + 16, "mean of a generation", "end", "#6b7580"))
    parts.append("</svg>\n")
    path.write_text("\n".join(parts))
