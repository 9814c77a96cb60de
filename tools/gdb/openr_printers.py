"""Pretty printers of gdb for data of OPEN-R.

    (gdb) source share/openr-host/gdb/openr_printers.py

openr run --gdb does this itself.  "set print pretty on" shows one value on each line.
"""

import gdb
import gdb.printing

ELEMENTS_MAX = 64  # elements of a vector that are shown; a count that was never set may be any number


def elements(vector, count):
    """Yields the first `count` elements of vector.info, whose declared size is 1."""
    info = vector["info"]
    first = info[0].address
    for i in range(min(int(count), ELEMENTS_MAX)):
        yield i, (first + i).dereference()


def as_type(value, name):
    """Returns `value`, an address, as a pointer to the type `name`; None if gdb lacks the type."""
    try:
        return value.cast(gdb.lookup_type(name).pointer())
    except gdb.error:
        return None


def locators():
    """Returns the CPC locators by the numbers of their primitives; none before there is a robot."""
    try:
        lines = gdb.parse_and_eval("(const char *) &openr_locators").string().splitlines()
    except gdb.error:  # a program without the runtime
        return {}
    return {int(number): locator for number, locator in (line.split(" ") for line in lines)}


def primitive(number):
    """Returns the CPC locator of a primitive, or its number where the program does not know it."""
    return locators().get(int(number), "primitive %d" % int(number))


class PrimitiveIdPrinter:
    """OPrimitiveID: the CPC locator beside the number."""

    def __init__(self, value):
        self.value = value

    def to_string(self):
        number = int(self.value.cast(self.value.type.strip_typedefs()))
        name = primitive(number)
        return str(number) if name.startswith("primitive ") else "%d %s" % (number, name)


class RegionPrinter:
    """RCRegion: id, size, references and the first bytes."""

    def __init__(self, value):
        self.value = value

    def to_string(self):
        region = self.value
        size = int(region["size_"])
        text = "region %#x, %d bytes, %d references" % (
            int(region["id_"]), size, int(region["count_"]))
        if int(region["offset_"]) != 0:
            text += ", offset %d" % int(region["offset_"])
        base = region["base_"]
        if int(base) == 0:
            return text + ", no memory"
        return text + ", at %#x: %s" % (int(base), self.first_bytes(base, size))

    @staticmethod
    def first_bytes(base, size):
        shown = min(size, 16)
        try:
            data = gdb.selected_inferior().read_memory(int(base), shown).tobytes()
        except gdb.MemoryError:
            return "not readable"
        return data.hex(" ") + (" ..." if size > shown else "")


class VectorPrinter:
    """Vectors of primitives: the elements in use, not the one element of the declaration."""

    def __init__(self, value):
        self.value = value

    def count(self):
        return int(self.value["vectorInfo"]["numData"])

    def to_string(self):
        info = self.value["vectorInfo"]
        return "%s, %d of %d elements" % (
            self.value.type.strip_typedefs().name, self.count(), int(info["maxNumData"]))

    def children(self):
        for i, info in elements(self.value, self.count()):
            yield "[%d]" % i, self.describe(i, info)

    def describe(self, i, info):
        return info


class SensorVectorPrinter(VectorPrinter):
    """OSensorFrameVectorData: each sensor with its values, the newest frame last."""

    def describe(self, i, info):
        count = min(int(info["numFrames"]), 16)
        start = as_type(self.value.address, "char")
        frames = as_type(start + int(info["dataOffset"]), "int")
        # A frame has 16 bytes, and its value comes first.
        values = [str(int(frames[4 * k])) for k in range(count)]
        return "%s, frame %d: %s" % (
            primitive(info["primitiveID"]), int(info["frameNumber"]), " ".join(values))


class CommandVectorPrinter(VectorPrinter):
    """OCommandVectorData: each primitive with its set points."""

    def describe(self, i, info):
        count = min(int(info["numFrames"]), 16)
        start = as_type(self.value.address, "char")
        frames = as_type(start + int(info["dataOffset"]), "int")
        values = [str(int(frames[2 * k])) for k in range(count)]
        return "%s, %d frames: %s" % (
            primitive(info["primitiveID"]), int(info["numFrames"]), " ".join(values))


class NotifyPrinter:
    """ONotifyEvent: the observer's index and the regions that came."""

    def __init__(self, value):
        self.value = value

    def to_string(self):
        return "notification for observer %d, %d data" % (
            int(self.value["index_"]), int(self.value["numOfData_"]))

    def children(self):
        for i in range(min(int(self.value["numOfData_"]), ELEMENTS_MAX)):
            region = self.value["rcr_"][i]
            yield "[%d]" % i, region.dereference() if int(region) != 0 else region


PRINTERS = gdb.printing.RegexpCollectionPrettyPrinter("openr")
PRINTERS.add_printer("OPrimitiveID", "^OPrimitiveID$", PrimitiveIdPrinter)
PRINTERS.add_printer("RCRegion", "^RCRegion$", RegionPrinter)
PRINTERS.add_printer("OSensorFrameVectorData", "^OSensorFrameVectorData$", SensorVectorPrinter)
PRINTERS.add_printer("OCommandVectorData", "^OCommandVectorData$", CommandVectorPrinter)
PRINTERS.add_printer("vectors",
                     "^O(FbkImageVector|CdtVector|SoundVector|PrimitiveMap|CPCTree)Data$",
                     VectorPrinter)
PRINTERS.add_printer("ONotifyEvent", "^ONotifyEvent$", NotifyPrinter)
gdb.printing.register_pretty_printer(None, PRINTERS, replace=True)
