"""What the soak reads of files and processes."""
import struct


class Problem(Exception):
    """Something that must not happen."""


def bits_of(path):
    """The channels, the windows and the pixels of an EXR of scan lines. Other attributes, such as times, differ between runs."""
    data = path.read_bytes()
    if data[:4] != b"\x76\x2f\x31\x01":
        raise Problem(f"{path.name} is no EXR")
    place, kept = 8, {}
    while data[place]:
        name, kind = data[place:].split(b"\0", 2)[:2]
        place += len(name) + len(kind) + 2
        (size,) = struct.unpack_from("<i", data, place)
        if name in (b"channels", b"dataWindow", b"displayWindow", b"compression"):
            kept[name] = data[place + 4 : place + 4 + size]
        place += 4 + size
    (first,) = struct.unpack_from("<q", data, place + 1)
    return kept, data[first:]


def seconds_kept(path):
    """The seconds of rendering that a checkpoint holds (host/film/record_file.h); 0 without one. It has to be whole."""
    if not path.exists():
        return 0.0
    data, place, seconds, tag = path.read_bytes(), 32, 0.0, b""
    while place + 24 <= len(data):
        tag, _, size, _, _ = struct.unpack_from("<4sIQII", data, place)
        if tag == b"TIME":
            (seconds,) = struct.unpack_from("<d", data, place + 24)
        place += 24 + size
    if tag != b"LAST" or place != len(data):
        raise Problem(f"{path.name} is not whole")
    return seconds


def memory_of(process):
    """Bytes of memory that a process has of its own, without pages of files; 0 if it has ended."""
    try:
        with open(f"/proc/{process}/status") as status:
            return next((int(line.split()[1]) << 10 for line in status if line.startswith("RssAnon:")), 0)
    except OSError:
        return 0
