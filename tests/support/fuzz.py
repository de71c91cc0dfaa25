"""Specs by the dozen: a grammar made from a dictionary, mutations of bytes, and what must hold."""

import ast
import re
import types
import unicodedata
import warnings
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import PurePosixPath
from random import Random
from xml.sax.saxutils import quoteattr

import yaml
from hypothesis import strategies as st

from hooks.dictionary import nested

WORDS = """
    a b x n out pub client action service message config goal state status pose arm arm_driver
    driver test_n_impl test_x_node on off yes no null y max min id type input filter list self cls
    node data log now stamp update configure x_active x_updated worker transforms logger Transform
    name params groups value index exp time T A aB a_b A_b ros rclpy print object launch
    Dynamic x_dynamic data_ config_ NO Null msg srv Node Impl impl out_x in_x
""".split()
ODD_WORDS = """
    in test linux unix NULL EOF true str Sequence std uninstall gencfg install INSTALL edit_cache
    preinstall LifecycleNode lifecycle None False errno stdin stdout M_PI SIGINT class private a__b
""".split()
TYPES = {
    "message_type": [
        "std_msgs::String",
        "std_msgs/Int64",
        "geometry_msgs::Twist",
        "std_msgs/msg/Bool",
    ],
    "stamped_type": ["geometry_msgs::PointStamped", "geometry_msgs/TwistStamped"],
    "service_type": ["std_srvs::Trigger", "std_srvs/srv/Empty", "std_srvs::SetBool"],
    "action_type": ["test_msgs::Fibonacci", "control_msgs/action/Grip"],
}
FIELD_TYPES = ["bool", "byte", "char", "float32", "float64", "int8", "uint16", "int32", "uint64"]
FIELD_TYPES += ["string", "wstring", "time", "duration", "Header", "std_msgs::String", "string<=9"]
FIELD_TYPES += [type_ + array for type_ in FIELD_TYPES for array in ("[]", "[3]", "[<=3]")]
NO_VALUES = [type_ for type_ in FIELD_TYPES if re.match("time|duration|Header|std_msgs", type_)]
ODD_TYPES = [
    "class::T",
    "std_msgs::None",
    "threading::T",
    "pkg::T",
    "std_msgs::Time",
    "actionlib::TwoInts",
    "T",
    "a::b::c",
    "linux::T",
    "a/b",
]
TEXTS = [
    '"""',
    "'''",
    "*/",
    "/*",
    "//",
    "-->",
    "<!--",
    "]]>",
    "{{ 7 * 7 }}",
    "{% raw %}",
    "{# x",
    "${PATH}",
    "$(id)",
    "\\",
    "??/",
    "a\\",
    "`id`",
    "'); import os #",
    "%s %d {0}",
    "@name@",
    "\t",
    "\n\n",
    "# x",
    "|",
    "||",
    "]([x",
    "---",
    "...",
    "a: b",
    "- a",
    "&a *b !c",
    "\ufeff",
    "\u200b",
    "für",
    "日本語" * 20,
    "👍🏽",
    "e\u0301",
    "\\N{DASH}",
    "\\u0041",
    "x" * 300,
    "word " * 60,
    'R"(',
    '"',
    "'",
    "<",
    "&amp;",
    "TODO(x)",
    "noqa",
    "# noqa",
    "NOLINT",
    "1",
    "true",
    "null",
    "~",
    "  a  ",
]
CONTROLS = ["\x7f", "\x85", "\x9f", "\u2028", "\u202e", "\u2066", "\x01"]
NUMBERS = [
    "0",
    "1",
    "-1",
    "0.5",
    "1e300",
    "5e-324",
    "-0.0",
    "1e22",
    "100",
    "3000000000",
    "-9223372036854775808",
    "9223372036854775807",
    "9223372036854775808",
    "007",
    "+3",
    "inf",
    "nan",
    "1_0",
    "٣",
    "9" * 30,
    "1e-7",
]


class Author(Random):
    """Writes specs: most of what it writes is right, and all of it from the dictionary."""

    named = types.MappingProxyType({})
    """What may be referred to: the attributes of the elements written so far, by tag."""
    held = types.MappingProxyType({})
    """The same of what stands in each element that others take, by the name of it."""

    def seldom(self, times):
        return self.randrange(times) == 0

    def word(self):
        if self.seldom(60):
            return self.choice(ODD_WORDS)
        if self.seldom(2):
            return self.choice(WORDS)
        return "".join(self.choices("abcxyzABC", k=self.randint(1, 4))) + self.choice(
            ["", "_1", "2"]
        )

    def ros_name(self):
        path = "/".join(self.word() for _ in range(self.choice([1, 1, 1, 2, 3])))
        return self.choice(["", "", "", "/", "~/", "~"]) + path

    def text(self):
        pieces = [self.choice([*TEXTS, self.letters()]) for _ in range(self.randint(1, 4))]
        return "".join(pieces) + (self.choice(CONTROLS) if self.seldom(300) else "")

    def letters(self):
        signs = (
            chr(self.choice([self.randrange(32, 0x250), self.randrange(0x20000)]))
            for _ in "123456"
        )
        return "".join(sign for sign in signs if unicodedata.category(sign)[0] != "C")

    def number(self):
        if self.seldom(30):
            return self.choice(NUMBERS)
        return self.choice(
            [
                str(self.randint(-99, 99)),
                repr(self.uniform(-1e9, 1e9)),
                repr(10.0 ** self.randint(-300, 300)),
            ]
        )

    def literal(self, type_name):
        base, is_list, size = re.fullmatch(r"([^<\[]*)[^\[]*(\[\D*(\d*)\])?", type_name).groups()
        if is_list:
            items = [_in_list(self.literal(base)) for _ in range(int(size or self.randint(1, 5)))]
            return f"[{', '.join(items)}]"
        if re.fullmatch(r"u?int\d+|byte|char", base):
            return self.choice(NUMBERS) if self.seldom(30) else str(self.randint(0, 99))
        if type_name == "int":
            whole = [str(self.randint(-99, 99)), str(self.randint(-(2**63), 2**63 - 1))]
            return self.choice(NUMBERS) if self.seldom(30) else self.choice(whole)
        if type_name == "bool":
            return self.choice(["true", "false", "yes", "0"])
        if base in ("double", "float32", "float64"):
            return self.number()
        return self.choice([self.text(), self.word()])

    def anything(self):
        return self.choice(
            [self.text(), self.word(), self.ros_name(), self.choice(NUMBERS), "[[1]", "[a, 'b"]
        )

    def attribute(self, given, made, others):
        if self.seldom(300):
            return self.anything()
        if given.refers_to:
            names = self.names(given) or [self.word()]
            return self.word() if self.seldom(50) else self.choice(names)
        if given.choices:
            pairs = given.choices.items()
            return self.choice([word for one, more in pairs for word in (one, *more)])
        if given.format == "literal":
            words = others[given.of].choices
            written = made.get(given.of, "")
            type_name = next((w for w in words if written in (w, *words[w])), "")
            return self.literal(type_name or (written if written in FIELD_TYPES else ""))
        if given.format in TYPES:
            return self.choice(ODD_TYPES if self.seldom(100) else TYPES[given.format])
        if given.format == "number":
            return self.choice(NUMBERS) if self.seldom(30) else self.choice(["1", "12.5", "1000"])
        rights = {
            "ros_name": self.ros_name,
            "relative_name": lambda: self.ros_name().lstrip("/~"),
            "dotted_name": lambda: self.choice(["", "", f"{self.word()}."]) + self.word(),
            "grouped_name": lambda: self.choice(["", "", f"{self.word()}."]) + self.word(),
            "identifier": self.word,
            "component_name": self.word,
            "interface_name": lambda: self.word().replace("_", "").capitalize(),
            "field_name": lambda: self.word().lower(),
            "constant_name": lambda: self.word().upper(),
            "field_type": lambda: self.choice(ODD_TYPES if self.seldom(100) else FIELD_TYPES),
            "package_name": lambda: self.choice([*["arm", "pkg", "my_arm", "on"] * 20, "test"]),
            "email": lambda: "a@example.org",
            "license": lambda: self.choice(["MIT", "Apache-2.0", "Our own", "BSD"]),
            "version": lambda: self.choice(["1.2.0", "0.0.1", "10.20.30"]),
            "url": lambda: f"https://example.org/{self.word()}?a=1&b=2",
            "file_name": lambda: self.choice([self.word(), "joy-teleop", "listener.py", "2d"]),
            "bool": lambda: self.literal("bool"),
            "int": lambda: self.choice(NUMBERS if self.seldom(30) else ["1", "10", "1000"]),
        }
        return rights.get(given.format, self.text)()

    def names(self, given):
        """Return the names that an attribute may refer to."""
        return [
            next(iter(made.values()))
            for made in self.named.get(given.refers_to, [])
            if made and all(made.get(name) in words for name, words in given.whose.items())
        ]

    def element(self, tag, attributes, inside=""):
        made = {}
        for name, given in attributes.items():
            unfit = any(
                made.get(other) not in (words or [None]) for other, words in given.when.items()
            )
            unfit |= given.format == "literal" and made.get(given.of) in NO_VALUES
            unfit |= bool(given.refers_to) and not self.names(given)
            if not given.ignored and (not given.optional or self.seldom(100 if unfit else 2)):
                made[name] = self.attribute(given, made, attributes)
        if made and self.seldom(500):
            made.pop(self.choice(list(made)))
        shown = "".join(f" {name}={quoteattr(text)}" for name, text in made.items())
        plain_words = {
            name: next(
                (one for one, more in attributes[name].choices.items() if text in more), text
            )
            for name, text in ((name, text.strip()) for name, text in made.items())
        }
        self.named.setdefault(tag, []).append(plain_words)
        return f"<{tag}{shown}>{inside}</{tag}>\n"

    def inside(self, owner):
        """Return interface kinds, and the XML of one of each inside of an owner."""
        known = [
            kind
            for kind in owner.interfaces.values()
            if not kind.takes or kind.taken in self.named or self.seldom(50)
        ]
        kinds = self.choices(known, k=self.randint(0, 8)) if known else []
        if not self.seldom(30):
            kinds = [
                kind
                for i, kind in enumerate(kinds)
                if not (kind.once or kind.takes) or kind not in kinds[:i]
            ]
        for kind in () if self.seldom(30) else known:
            kinds += [kind] * (kind.least - kinds.count(kind))
        texts = {}
        for place in sorted(range(len(kinds)), key=lambda place: _turn(kinds[place])):
            kind = kinds[place]
            texts[place] = self.element(kind.kind, kind.attributes, self.inside(kind)[1])
            taken = self.named[kind.kind][-1].get(kind.naming) if kind.takes else None
            for tag, held in self.held.get(taken, {}).items():
                self.named.setdefault(tag, []).extend(held)
        return kinds, "".join(texts[place] for place in sorted(texts))

    def spec(self, dictionary):
        """Return the XML of a spec that a dictionary may allow."""
        parts = []
        self.named, self.held = {}, {}
        shared = set()  # what the interfaces require that components may take
        known = dictionary.components.values()
        known = [each for each in known if each.is_plain or not each.is_optional or self.seldom(4)]
        components = self.choices(known, k=self.choice([1, 1, 2, 4]))
        needed = dictionary.needed
        if needed and all(each.is_optional for each in components) and not self.seldom(4):
            components.append(self.choice(needed))
        for component in sorted(components, key=lambda each: not each.is_shared):
            tags = {kind.kind for kind in nested(component.interfaces)}
            self.named = {tag: made for tag, made in self.named.items() if tag not in tags}
            kinds, inside = self.inside(component)
            attributes = component.attributes
            required = {name for kind in kinds for name in kind.requires}
            shared |= required if component.is_shared else set()
            if not self.seldom(10):  # what the interfaces require
                required |= shared if any(kind.takes for kind in kinds) else set()
                attributes = {
                    name: replace(given, optional=given.optional and name not in required)
                    for name, given in attributes.items()
                }
            parts.append(self.element(component.tag, attributes, f"\n{inside}"))
            if component.is_shared:
                name = self.named[component.tag][-1].get(component.naming)
                self.held[name] = {tag: self.named[tag] for tag in tags & self.named.keys()}
        if self.seldom(4):
            parts.append(
                f"<depend>{self.choice(['roscpp', 'rclpy', 'nav_msgs', 'tf'])}</depend>\n"
            )
        return self.element("package", dictionary.package, f"\n{''.join(parts)}").encode()

    def mutation(self, text):
        """Return bytes with some of them cut, doubled, moved or exchanged."""
        for _ in range(self.randint(1, 3)):
            start = self.randrange(len(text) + 1)
            piece = text[start : start + self.randint(0, 40)]
            others = [b"", piece * 2, piece[::-1], piece * 50, self.randbytes(self.randint(1, 4))]
            text = text[:start] + self.choice(others) + text[start + len(piece) :]
        return text

    def input(self, dictionary):
        spec = self.spec(dictionary)
        return self.mutation(spec) if self.seldom(3) else spec


class Stylist(Author):
    """Writes the same in other ways: blanks, comments, other tags, names before."""

    def attribute(self, given, made, others):
        text = super().attribute(given, made, others)
        blanks = given.choices or given.format == "bool"
        return self.blanks() + text + self.blanks() if blanks and self.seldom(4) else text

    def element(self, tag, attributes, inside=""):
        parts = super().element(tag, attributes, inside).partition(">")
        was = ' was="before"' if self.seldom(20) else ""
        return f"{parts[0]}{was}>{self.gap()}{parts[2]}{self.gap()}"

    def spec(self, dictionary):
        text = super().spec(dictionary).decode()
        for alias, tag in dictionary.aliases.items():
            text = re.sub(rf"<(/?){tag}\b", rf"<\1{alias}", text) if self.seldom(2) else text
        return f"{text.strip()}{self.gap()}".encode()

    def gap(self):
        more = ["<!-- <x a='1'> -->", "<?editor x?>", "&#32;&#9;"]
        gaps = self.choices(["", "", self.blanks(), *(more if self.seldom(2) else [])], k=3)
        return "".join(gaps)

    def blanks(self):
        return "".join(self.choices(" \t\n", k=self.randint(0, 3)))


class LongNames(Author):
    """Writes names of 3 to 60 letters."""

    def word(self):
        letters = self.choices("abcdefghijklmnopqrstuvwxyz", k=self.randint(3, 60))
        for place in range(self.randint(3, 12), len(letters) - 1, self.randint(2, 12)):
            letters[place] = "_"
        return "".join(letters)

    def ros_name(self):
        name = self.word()
        inside = name.replace("_", "/", self.randint(1, 3)) if self.seldom(3) else name
        return self.choice(["", "", "", "/", "~/", "~"]) + inside

    def attribute(self, given, made, others):
        if given.format == "package_name":
            return self.word()
        if given.format in TYPES:
            long_one = f"{self.word()}/{self.word().title().replace('_', '')}"
            return self.choice([*TYPES[given.format] * 2, long_one])
        return super().attribute(given, made, others)


def authors():
    """Return a strategy for authors, as unlike each other as their numbers.

    A number is drawn in bits: Hypothesis (6.170) mixes numbers that stand in the modules loaded
    so far among its integers, and the authors would depend on the tests that ran before.
    """
    bits = st.lists(st.booleans(), min_size=32, max_size=32)
    return bits.map(lambda drawn: Author(Random(bytes(drawn)).getrandbits(64)))


def inputs(dictionary):
    return authors().map(lambda author: author.input(dictionary))


def styles(dictionary):
    return authors().map(lambda author: Stylist(author.getrandbits(64)).input(dictionary))


def specs(dictionary):
    return authors().map(lambda author: author.spec(dictionary))


def _turn(kind):
    """Return when a kind is written: what is referred to comes before what refers to it."""
    return (not kind.takes, any(given.refers_to for given in kind.attributes.values()))


def _in_list(text):
    plain_word = re.fullmatch(r"[\w.+-]+", text, re.ASCII)
    return text if plain_word else "'" + text.replace("'", "''") + "'"


def plain(value):
    """Return a context with plain words for the texts of the user's, which have no form."""
    if isinstance(value, dict):
        words = ("description", "author", "copyright")
        return {
            k: "word" if k in words and v else _plain_value(value, k, plain(v))
            for k, v in value.items()
        }
    return [plain(item) for item in value] if isinstance(value, list) else value


def _plain_value(owner, key, value):
    if key not in ("value", "default") or value is None or "string" not in str(owner.get("type")):
        return value
    return ["word" for _ in value] if isinstance(value, list) else "word"


def code(name, text):
    """Return what a file says to a machine, without comments and texts.

    Raises:
        Exception: the file cannot be parsed, or a parser warns.

    """
    if name.endswith((".py", ".cfg")) and name != "setup.cfg":
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            compile(text.encode(), name, "exec", dont_inherit=True)  # with its encoding
        tree = ast.parse(text)
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                node.value = ""
        return ast.dump(tree)
    if name.endswith((".xml", ".launch", ".test")):
        return [(item.tag, sorted(item.attrib)) for item in ET.fromstring(text).iter()]
    if name.endswith(".yaml"):
        return list(keys(yaml.safe_load(text)))
    if name.endswith((".hpp", ".cpp")):
        return cpp_tokens(text)
    if name == "CMakeLists.txt":
        return cmake_commands(text)
    if name.endswith((".msg", ".srv", ".action")):
        return interface_lines(text)
    return mermaid(text) if name == "README.md" else None


def interface_lines(text):
    """Return the lines of an interface without comments, each text as one."""
    lines = [line.rstrip() for line in text.split("\n") if line.rstrip() and line[0] != "#"]
    lines = [re.sub(r"^(w?string \w+=).*", r"\1", line) for line in lines]
    return [re.sub(r'"(?:[^"\\]|\\.)*"', '"', line) for line in lines]


def keys(value):
    for key, inside in value.items() if isinstance(value, dict) else ():
        yield key
        yield from keys(inside)


def cpp_tokens(text):
    """Return the tokens of C++, each text as one; comments end where a compiler sees it."""
    spliced = re.sub(r"(\\|\?\?/)[ \t]*\n", "", text)
    form = r'//[^\n]*|/\*.*?\*/|R"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|\w+|[^\s\w]'
    found = [
        token
        for token in re.findall(form, spliced, re.DOTALL)
        if not token.startswith(("//", "/*"))
    ]
    tokens = ['"' if token.startswith('"') and len(token) > 1 else token for token in found]
    assert 'R"' not in tokens
    return [
        t for t, before in zip(tokens, ["", *tokens], strict=False) if t != '"' or before != '"'
    ]


def cmake_commands(text):
    """Return the commands of a CMake file with their arguments; no target may be made twice."""
    lines = re.sub(r"#[^\n]*", "", text)
    argument = r'"(?:[^"\\]|\\.)*"|[^\s()"#]+|\((?:[^()]*)\)'
    form = rf"\s*(\w+)\s*\(((?:\s|{argument})*)\)"
    commands, end = [], 0
    while match := re.compile(form).match(lines, end):
        commands.append((match[1], re.findall(argument, match[2])))
        end = match.end()
    assert not lines[end:].strip(), f"not CMake: {lines[end : end + 80]!r}"
    adds = (
        "add_executable",
        "add_library",
        "ament_add_gtest",
        "catkin_add_gtest",
        "add_rostest_gtest",
    )
    targets = [arguments[0] for command, arguments in commands if command in adds]
    targets += [a[a.index("EXECUTABLE") + 1] for _, a in commands if "EXECUTABLE" in a]
    assert len(set(targets)) == len(targets), targets
    return commands


def mermaid(text):
    """Return the lines of the diagrams without labels; a name has one label only."""
    lines, labels = [], {}
    for diagram in re.findall(r"^```mermaid\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
        first, *rest = diagram.splitlines()
        assert first == "flowchart LR"
        shape = r'(\w+)((?:\(\[|\[\[|\{\{|\[)("(?:[^"<>#]|#\w+;)*"|tf)(?:\]\)|\]\]|\}\}|\]))?'
        for line in rest:
            match = re.fullmatch(rf"  {shape}(?: (-->|---|-\.->) {shape})?", line)
            assert match, f"not Mermaid: {line!r}"
            lines.append((match[1], match[4], match[5]))
            for name, label in ((match[1], match[3]), (match[5], match[7])):
                if name and label:
                    bare = label.strip('"').removeprefix("/")
                    assert (
                        "~" in bare + labels.get(name, bare)
                        or labels.setdefault(name, bare) == bare
                    ), name
    return lines


def check_own_files(files, package):
    """Check that the headers and modules of the package that its code names are there."""
    headers = {name.split("/", 1)[1] for name in files if name.endswith(".hpp")}
    for name, text in files.items():
        if name.endswith((".hpp", ".cpp")):
            for own in re.findall(rf'^#include "((?:ros|{package})/.*\.hpp)"', text, re.MULTILINE):
                assert own in headers, f"{name} includes {own}"
            for own in re.findall(r'^#include "(\w+\.hpp)"', text, re.MULTILINE):
                assert str(PurePosixPath(name).with_name(own)) in files, f"{name} includes {own}"
        elif name.endswith(".py"):
            own_imports = rf"^from {package}\.([\w.]+) import (\w*)"
            for own, first in re.findall(own_imports, text, re.MULTILINE):
                path = f"{package}/{own.replace('.', '/')}"
                found = {f"{path}.py", f"{path}/{first}.py"} & files.keys()
                assert own in {"cfg", "msg"} or found, f"{name}: {own}"


def check(files, harmless, spec):
    """Check the files of a package against those of the same spec with harmless texts.

    Raises:
        AssertionError: a file is unsound, or a text of the spec has become code.

    """
    assert files.keys() == harmless.keys()
    for name, text in files.items():
        assert not re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]", text), name
        assert code(name, text) == code(name, harmless[name]), f"{name}: a text has become code"
    check_own_files(files, spec["name"])
    for node in spec.get("nodes", []):
        for started in node["instances"] or [node]:
            config = yaml.safe_load(files[f"config/{started['name']}.yaml"])
            found = config["/**"]["ros__parameters"] if spec["ros"] == 2 else config
            for parameter in [*node["parameters"], *node["dynParameters"]]:
                value, name = parameter["value"], parameter["name"]
                name = name if spec["ros"] == 2 else name.replace(".", "/")
                if value is None or (value == [] and spec["ros"] == 2):
                    assert name not in found, name
                else:
                    assert (found[name], type(found[name])) == (value, type(value)), name
