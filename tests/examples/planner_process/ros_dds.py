"""ROS 2's topics for Python without ROS: Eclipse Cyclone DDS by ctypes, messages from their IDL.

    with Domain(["nav_msgs/msg/Odometry"]) as domain:
        odom = domain.reader("/odom", "nav_msgs/msg/Odometry")
        domain.wait(1.0)
        for message in odom.take():
            print(message.pose.pose.position.x)

Messages are ctypes structures with the field names of ROS 2: texts are bytes, sequences have len() and elements. Debian:
apt install cyclonedds-dev cyclonedds-tools gcc. The first start compiles the message types (0.5 s), later ones find them."""
import ctypes as c
import hashlib
import os
import pathlib
import re
import subprocess
import tempfile

PLACES = [*pathlib.Path(__file__).resolve().parents, pathlib.Path("/usr/share/bandwagon")]
IDL = next(folder / "idl" for folder in PLACES if (folder / "idl" / "std_msgs").is_dir())
KINDS = {"boolean": c.c_bool, "octet": c.c_uint8, "string": c.c_char_p, "float": c.c_float, "double": c.c_double,
         **{f"{sign}int{bits}": getattr(c, f"c_{sign}int{bits}") for sign in ("", "u") for bits in (8, 16, 32, 64)}}
LOOPBACK = """<General><Interfaces><NetworkInterface name="lo" multicast="false"/></Interfaces><AllowMulticast>false</AllowMulticast>
</General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>31</MaxAutoParticipantIndex>
<Peers><Peer Address="127.0.0.1"/></Peers></Discovery>"""
RELIABLE, TRANSIENT_LOCAL, KEEP_LAST, ANY_STATE = 1, 1, 0, 127  # numbers of dds.h


def idl_of(name: str, seen: set) -> str:
    """The description of a message behind those that it is made of, each once; structs named as on ROS 2's wire."""
    if name in seen:
        return ""
    seen.add(name)
    text = re.sub(r"//.*", "", (IDL / f"{name}.idl").read_text())
    before = "".join(idl_of(include, seen) for include in re.findall(r'#include "(.+)\.idl"', text))
    text = re.sub(r"#include.*", "", text)
    text = re.sub(r"(\w+)::msg::(\w+)", r"\1::msg::dds_::\2_", text)
    text = re.sub(r"struct (\w+)", r"module dds_ { struct \1_", text)
    return before + re.sub(r"(struct .*?\};)", r"\1 };", text, flags=re.S)


def compiled(idl: str) -> c.CDLL:
    """Library of the message types, with all of Cyclone DDS behind it."""
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "bandwagon"
    library = cache / f"messages_{hashlib.sha256(idl.encode()).hexdigest()[:16]}.so"
    if not library.exists():
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache) as folder:
            (pathlib.Path(folder) / "messages.idl").write_text(idl)
            subprocess.run(["idlc", "-f", "case-sensitive", "-x", "final", "-t", "messages.idl"], cwd=folder, check=True)
            subprocess.run(["cc", "-shared", "-fPIC", "-o", "messages.so", "messages.c", "-Wl,--no-as-needed", "-lddsc"], cwd=folder, check=True)
            (pathlib.Path(folder) / "messages.so").rename(library)
    return c.CDLL(str(library))


def sequence_of(kind):
    return type("Sequence", (c.Structure,), {
        "_fields_": [("maximum", c.c_uint32), ("length", c.c_uint32), ("buffer", c.POINTER(kind)), ("release", c.c_bool)],
        "__len__": lambda self: self.length,
        "__iter__": lambda self: (self.buffer[i] for i in range(self.length)),
        "__getitem__": lambda self, i: self.buffer[range(self.length)[i]]})


def structures(idl: str) -> dict:
    """A ctypes structure for each struct, by its ROS 2 name, laid out as idlc's C."""
    known = {}
    for package, name, body in re.findall(r"module (\w+) \{\s*module msg \{.*?struct (\w+)_ \{(.*?)\}", idl, re.S):
        fields = []
        for kind, field, size in re.findall(r"([\w:<>]+) (\w+)(?:\[(\d+)\])?;", body):
            inner = re.sub(r"sequence<(.*)>", r"\1", kind)
            known_kind = KINDS.get(inner) or known[re.sub(r"::msg::dds_::(\w+)_", r"/msg/\1", inner)]
            known_kind = sequence_of(known_kind) if inner != kind else known_kind
            fields.append((field, known_kind * int(size) if size else known_kind))
        known[f"{package}/msg/{name}"] = type(name, (c.Structure,), {"_fields_": fields})
    return known


class SampleInfo(c.Structure):
    _fields_ = [("states", c.c_int * 3), ("valid", c.c_bool), ("numbers", c.c_int64 * 3), ("ranks", c.c_uint32 * 5)]


class Domain:
    """A participant in the domain ROS_DOMAIN_ID, on the loopback device unless CYCLONEDDS_URI says otherwise."""

    def __init__(self, messages: list):
        seen: set = set()
        idl = "".join(idl_of(name, seen) for name in messages)
        os.environ.setdefault("CYCLONEDDS_URI", LOOPBACK)
        self.dds, self.structures = compiled(idl), structures(idl)
        self.participant = self.checked(self.dds.dds_create_participant(int(os.environ.get("ROS_DOMAIN_ID") or 0), None, None))
        self.waitset = self.checked(self.dds.dds_create_waitset(self.participant))
        self.dds.dds_create_qos.restype = c.c_void_p

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.dds.dds_delete(self.participant)

    def checked(self, result: int) -> int:
        if result < 0:
            raise RuntimeError(f"Cyclone DDS says {result}")
        return result

    def end(self, create, topic: str, kind: str) -> int:
        """Reliable and transient local: whoever comes later gets the newest message."""
        package, _, name = kind.split("/")
        descriptor = c.byref(c.c_byte.in_dll(self.dds, f"{package}_msg_dds__{name}__desc"))
        of_topic = self.checked(self.dds.dds_create_topic(self.participant, descriptor, f"rt{topic}".encode(), None, None))
        qos = c.c_void_p(self.dds.dds_create_qos())
        self.dds.dds_qset_reliability(qos, RELIABLE, c.c_int64(10**9))
        self.dds.dds_qset_durability(qos, TRANSIENT_LOCAL)
        self.dds.dds_qset_history(qos, KEEP_LAST, 1)
        return self.checked(create(self.participant, of_topic, qos, None))

    def reader(self, topic: str, kind: str) -> "Reader":
        return Reader(self, self.end(self.dds.dds_create_reader, topic, kind), self.structures[kind])

    def writer(self, topic: str, kind: str):
        """A function that publishes a message."""
        end = self.end(self.dds.dds_create_writer, topic, kind)
        return lambda message: self.checked(self.dds.dds_write(end, c.byref(message)))

    def wait(self, seconds: float):
        """Until any reader has something."""
        self.checked(self.dds.dds_waitset_wait(self.waitset, None, c.c_size_t(0), c.c_int64(int(seconds * 1e9))))


class Reader:
    def __init__(self, domain: Domain, end: int, kind):
        self.dds, self.end, self.kind = domain.dds, end, kind
        condition = domain.checked(self.dds.dds_create_readcondition(end, c.c_uint32(ANY_STATE)))
        domain.checked(self.dds.dds_waitset_attach(domain.waitset, condition, c.c_void_p(0)))

    def take(self):
        """What has come, each valid until the next is asked for."""
        while True:
            sample, info = c.c_void_p(None), SampleInfo()
            if self.dds.dds_take(self.end, c.byref(sample), c.byref(info), c.c_size_t(1), c.c_uint32(1)) <= 0:
                return
            if info.valid:
                yield c.cast(sample, c.POINTER(self.kind)).contents
            self.dds.dds_return_loan(self.end, c.byref(sample), 1)
