#!/usr/bin/env python3
"""Rebuilds font_data.inc: DejaVu Sans drawn once to grey pixels, so that drawing text needs no font library.

Run on a Debian with python3-pil and fonts-dejavu-core:  /usr/bin/python3 make_font.py > font_data.inc
DejaVu Sans is free to embed (Bitstream Vera licence; glyphs only, no font file is shipped).
Each row of a glyph is one string of hexadecimal coverage digits, one a pixel.
"""
from PIL import Image, ImageDraw, ImageFont

PIXELS = 22
LETTERS = [chr(code) for code in range(0x20, 0x7F)] + ["·", "–", "°", "µ"]

font = ImageFont.truetype("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", PIXELS)
ascent, descent = font.getmetrics()
print(f"// DejaVu Sans at {PIXELS} px, made by make_font.py; not edited. Columns: code point, advance, rows.")
print(f"inline constexpr int kLineHeight_px = {ascent + descent};")
print(f"inline constexpr Glyph kGlyphs[] = {{")
for letter in LETTERS:
    advance = round(font.getlength(letter))
    cell = Image.new("L", (advance + 2, ascent + descent), 0)
    ImageDraw.Draw(cell).text((0, 0), letter, font=font, fill=255)
    rows = []
    for y in range(cell.height):
        row = "".join("0123456789abcdef"[cell.getpixel((x, y)) // 16] for x in range(cell.width))
        rows.append('"' + row.rstrip("0") + '"')
    print(f"    {{0x{ord(letter):x}, {advance}, {{{', '.join(rows)}}}}},")
print("};")
