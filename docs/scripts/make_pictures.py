#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the pictures in docs/images with the program itself: docs/scripts/make_pictures.py [PROGRAM]

Each script runs with the command line in its header. The pictures are then packed more tightly,
without loss, as they are kept under version control.
"""
import pathlib
import shlex
import struct
import subprocess
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = ["readme.script", "screens.script", "tracking.script", "compare.script"]


def command_of(script):
    """The line '#   svoscope shot ...' of a script."""
    for line in script.read_text().splitlines():
        if line.startswith("#   svoscope "):
            return shlex.split(line[4:])
    sys.exit(f"{script}: no line '#   svoscope shot ...'")


def chunks(data):
    at = 8
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        at += 12 + size


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def unfiltered(raw, height, stride, bpp):
    """Rows as plain pixels; screenshots are flat, and flat rows deflate best unfiltered."""
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        if kind not in (0, 1, 2):
            return None
        if kind == 1:
            for i in range(bpp, stride):
                row[i] = (row[i] + row[i - bpp]) & 255
        elif kind == 2:
            for i in range(stride):
                row[i] = (row[i] + above[i]) & 255
        rows.append(b"\0" + bytes(row))
        above = row
    return b"".join(rows)


def pack(file):
    data = file.read_bytes()
    parts = list(chunks(data))
    width, height, _, colour = struct.unpack(">IIBB", parts[0][1][:10])
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    bpp = {0: 1, 2: 3, 6: 4}[colour]
    choices = [raw, unfiltered(raw, height, width * bpp, bpp)]
    best = min((zlib.compress(c, 9) for c in choices if c), key=len)
    packed = data[:8] + chunk(b"IHDR", parts[0][1]) + chunk(b"IDAT", best) + chunk(b"IEND", b"")
    file.write_bytes(min(packed, data, key=len))


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve()) if len(sys.argv) > 1 else str(ROOT / "build/svoscope")
    for name in SCRIPTS:
        command = command_of(ROOT / "docs/scripts" / name)
        done = subprocess.run([program] + command[1:], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
        for line in done.stdout.splitlines():
            file = ROOT / line
            if file.suffix == ".png":
                pack(file)
                print(f"{line}  {file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
