#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the same rectangle of several pictures side by side, each pixel a square: for pages about single pixels.

    enlarge_crops.py OUT.png LEFT TOP WIDTH HEIGHT TIMES COLUMNS PICTURE.png...

Pictures are 8-bit RGB or grey PNG files, such as `inkbench study` writes; all of a row stand beside each other, in order.
"""
import struct
import sys
import zlib

GAP = 4  # px between crops, white


def paeth(left, up, corner):
    guess = left + up - corner
    return min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]


def read_rows(path):
    """The rows of a PNG file as RGB bytes, from the top."""
    data = open(path, "rb").read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        chunk = data[at + 8 : at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            width, height, bits, colours = struct.unpack(">IIBB", chunk[:10])
            if bits != 8 or colours not in (0, 2):
                sys.exit(f"{path}: is no 8-bit RGB or grey PNG")
        if kind == b"IDAT":
            packed += chunk
    channels = 3 if colours == 2 else 1
    raw, stride, rows, above = zlib.decompress(packed), width * channels, [], None
    for y in range(height):
        start = y * (stride + 1)
        row, above = bytearray(raw[start + 1 : start + 1 + stride]), above or bytes(stride)
        for x in range(stride):
            left = row[x - channels] if x >= channels else 0
            corner = above[x - channels] if x >= channels else 0
            add = (0, left, above[x], (left + above[x]) // 2, paeth(left, above[x], corner))[raw[start]]
            row[x] = (row[x] + add) & 255
        rows.append(bytes(row) if channels == 3 else bytes(value for value in row for _ in range(3)))
        above = row
    return rows


def crop(path, left, top, width, height, times):
    rows = read_rows(path)[top : top + height]
    wide = [b"".join(row[3 * x : 3 * x + 3] * times for x in range(left, left + width)) for row in rows]
    return [row for row in wide for _ in range(times)]


def write_rows(path, rows):
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", body) + chunk(b"IEND", b""))


def main():
    out, numbers, pictures = sys.argv[1], [int(text) for text in sys.argv[2:8]], sys.argv[8:]
    columns, crops, rows = numbers[5], [crop(path, *numbers[:5]) for path in pictures], []
    for first in range(0, len(crops), columns):
        beside = crops[first : first + columns]
        if rows:
            rows += [b"\xff" * len(rows[0])] * GAP
        rows += [(b"\xff" * (3 * GAP)).join(parts) for parts in zip(*beside)]
    write_rows(out, rows)


main()
