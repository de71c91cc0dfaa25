"""Code that filters write, letter by letter: what is too long for its line is folded."""

import pytest

from extensions.cpp import cpp_comment, fit
from extensions.layout import fold_python
from extensions.python import (
    cfg_value,
    other_values,
    python_text,
    python_value,
    refused_values,
    sort_imports,
)
from extensions.qos import (
    offering,
    offers_times,
    qos_words,
    queue_size,
    rclcpp_qos,
    rclpy_qos,
    rclpy_qos_names,
)

LENGTHS = {"fifty": 50, "forty": 40, "thirty": 30}
"""What stands for names of so many letters."""
PYTHON = '''\
"""Sum up fifty, forty and more: thirty."""

from package.fifty import forty, thirty


class Node:
    """
    Words fifty fifty: thirty.

    One fifty two forty three.
    """

    # A comment fifty forty thirty.
    # fiftyfiftyfifty
    # A fifty word fifty-forty
    fifty_fifty = 1
    empty = [
    ]
    fiftyfortyfifty: Sequence[float] = (
        86.0,
    )
    fiftyfortyfifty: Sequence[float] = (
        86.0,
        87.0,
    )
    forty: Sequence[int] = (
        86,
    )

    forty: Sequence[int] = [fifty, thirty]

    def thirty(self, forty: x[int], thirty: y[int]) -> None:
        pass

    def fifty(self, forty: int, thirty) -> None:
        """Do it."""
        self.fifty = fifty.thirty
        self.fifty = forty.thirty(1)
        self.fifty['forty'] = call('thirty', 1)
        fifty = ['fifty', 'thirty', 3]
        forty += fifty.call(thirty)
        first(fifty, second(fifty), {'key': 'thirty'})
        fifty == call(forty, [1], thirty, x)
        fifty.thirty = ['thirty', 1]
        fifty(forty, thirty).call()
        forty = thirty.forty.thirty(
            forty,
        )
        nested(
            thirty + call(x=forty) + forty,
            fifty and forty and thirty,
            not fifty or forty and thirty,
            name=fifty.fifty,
            thirty=fifty.thirty,
            other=call(fifty + forty + thirty),
            text='(fifty' 'and) forty',
        )
        fifty.thirty.thirty = something(
            forty,
        )
        keyword(name=fifty, other=forty, more={})
        named(
            name=fifty + fifty,
            other={'fifty': forty + forty},
        )
        named(
            name=tuple(
                self.get(fifty, thirty).value or ()
            ),
        )
        return fifty + 'fifty' + thirty
'''
FOLDED_PYTHON = '''\
"""Sum up fifty."""

from package.fifty import (
    forty,
    thirty,
)


class Node:
    """
    Words fifty fifty.

    One fifty two
    forty three.
    """  # noqa: E501

    # A comment fifty
    # forty thirty.
    # fiftyfiftyfifty
    # A fifty word
    # fifty-forty
    fifty_fifty = 1  # noqa: E501
    empty = []
    fiftyfortyfifty: Sequence[  # noqa: E501
        float
    ] = (86.0,)
    fiftyfortyfifty: Sequence[  # noqa: E501
        float
    ] = (
        86.0,
        87.0,
    )
    forty: Sequence[int] = (
        86,
    )

    forty: Sequence[int] = [
        fifty,
        thirty,
    ]

    def thirty(
        self,
        forty: x[int],
        thirty: y[int],
    ) -> None:
        pass

    def fifty(
        self, forty: int, thirty
    ) -> None:
        """Do it."""
        self.fifty = (
            fifty.thirty
        )
        self.fifty = (
            forty.thirty(1)
        )
        self.fifty['forty'] = call(  # noqa: E501
            'thirty', 1
        )
        fifty = [
            'fifty',
            'thirty',
            3,
        ]
        forty += fifty.call(  # noqa: E501
            thirty
        )
        first(
            fifty,
            second(fifty),
            {'key': 'thirty'},
        )
        fifty == call(
            forty, [1], thirty, x
        )
        fifty.thirty = [
            'thirty',
            1,
        ]
        fifty(
            forty, thirty
        ).call()
        forty = thirty.forty.thirty(  # noqa: E501
            forty,
        )
        nested(
            thirty
            + call(x=forty)
            + forty,
            fifty
            and forty
            and thirty,
            not fifty
            or forty and thirty,
            name=fifty.fifty,  # noqa: E501
            thirty=(
                fifty.thirty
            ),
            other=call(
                fifty
                + forty
                + thirty
            ),
            text='(fifty' 'and) forty',  # noqa: E501
        )
        fifty.thirty.thirty = something(  # noqa: E501
            forty,
        )
        keyword(
            name=fifty,
            other=forty,
            more={},
        )
        named(
            name=fifty + fifty,  # noqa: E501
            other={
                'fifty': forty + forty,  # noqa: E501
            },
        )
        named(
            name=tuple(
                self.get(
                    fifty,
                    thirty,
                ).value
                or ()
            ),
        )
        return fifty + 'fifty' + thirty  # noqa: E501
'''
CPP = """\
#include "fifty/thirty_interface.hpp"
#ifndef FIFTY__forty_forty_HPP_
  // A comment fifty forty thirty and more words.
  // https://fifty.example.org/fiftythirty
  std::shared_ptr<Publisher<fifty::thirty>> fifty_member;
  fifty::Type thirty_member = std::make_shared<fifty>();
  const auto value = create_fifty<thirty>(first, "a, (b", second(forty, 2), 3);
  call_fifty(forty, [this](int a, int b) {return a;}, {1, 2}, thirty_first);
  if (fifty_first.thirty != fifty_second.forty) {
  if (fifty_first.thirty(1) == fifty_second.forty(x, 2)) {
  [[maybe_unused]] const fifty_types::forty & request_of_thirty)
  const fifty_types::thirty_message & forty_function(
void FiftyImpl::fifty_thirty::forty_callback_name_of(
  return std::vector<std::shared_ptr<fifty_types::thirty_forty>>{};
  using fifty_forty = thirty::fifty_type;
  using Shared = std::shared_ptr<std::shared_ptr<const fiftyConfig>>;
  std::shared_ptr<const fiftyConfig> current_configuration() const
  std::string reconfigure(const fiftyConfig & config) {return impl_->reconfigure(config);}
  void late_forty() {recorder_.called("late_forty");}
  double fortyfiftyabc = 1.0;
  bool fiftyfifty = true;
  std::vector<bool> fiftyfifty = {
    true
  };
void thirtyImpl::fiftyabcdefgh()
void thirtyImpl::fiftyabcdefghi()
void thirtyImpl::fiftyabcdefghij()
void fiftyabcdeImpl::thirtyabc()
struct fortyData : fiftyData, thirtyData, fortyOther
  using fiftyfifty = thirty::x;
  fifty::forty thirty = true;
  const fiftyforty & thirty;
  const fiftyfortyab & thirty;
  const fiftyfortyabc & thirty;
  fifty("forty \\" (, ", thirty_x);
  fifty().forty_name_x(thirty_x);
  fifty(thirty, {forty, thirty}, [](int a) {x;});
  std::map<std::vector<fifty>, forty> call(thirty);
  double fifty(int forty, thirty) const {return 1;}
  // A fifty fifty-forty
  x = fifty::forty::thirty;
"""
FOLDED_CPP = """\
// *INDENT-OFF*
#include "fifty/thirty_interface.hpp"
#ifndef FIFTY__forty_forty_HPP_
// *INDENT-ON*
  // A comment fifty
  // forty thirty and more words.
  // https://fifty.example.org/fiftythirty
  std::shared_ptr<Publisher<
      fifty::thirty>>
  fifty_member;
  fifty::Type
    thirty_member =
      std::make_shared<fifty>();
  const auto value =
    create_fifty<thirty>(
    first,
    "a, (b",
    second(forty, 2),
    3);
  call_fifty(
    forty,
    [this](int a, int b) {return a;},
    {1, 2},
    thirty_first);
  if (
    fifty_first.thirty !=
    fifty_second.forty)  // NOLINT(whitespace/line_length)
  {
  if (
    fifty_first.thirty(1) ==
    fifty_second.forty(  // NOLINT(whitespace/line_length)
      x,
      2))
  {
  [[maybe_unused]]
  const fifty_types::
  forty & request_of_thirty)
  const fifty_types::
  thirty_message &
  forty_function(
void FiftyImpl::fifty_thirty::
forty_callback_name_of(
  return std::vector<std::shared_ptr<
      fifty_types::
      thirty_forty>>{};
  using fifty_forty
    =
    thirty::fifty_type;
  using Shared =
    std::shared_ptr<std::shared_ptr<
        const fiftyConfig>>;
  std::shared_ptr<
    const fiftyConfig> current_configuration() const
  std::string reconfigure(const fiftyConfig & config)
  {
    return impl_->reconfigure(config);
  }
  void late_forty()
  {
    recorder_.called("late_forty");
  }
  double
    fortyfiftyabc =
    1.0;
  bool
    fiftyfifty  // NOLINT(whitespace/line_length)
    =
    true;
  std::vector<bool>
  fiftyfifty  // NOLINT(whitespace/line_length)
    =
    {
    true
    };
void thirtyImpl::  // NOLINT(whitespace/line_length)
fiftyabcdefgh()
void thirtyImpl::  // NOLINT(whitespace/line_length)
fiftyabcdefghi()
void thirtyImpl::
fiftyabcdefghij()
void fiftyabcdeImpl::  // NOLINT(whitespace/line_length)
thirtyabc()
struct fortyData
  : fiftyData,
  thirtyData, fortyOther
  using
  fiftyfifty  // NOLINT(whitespace/line_length)
    =
    thirty::x;
  fifty::forty
    thirty = true;
  const fiftyforty &
  thirty;
  const fiftyfortyab
  & thirty;
  const
  fiftyfortyabc
  & thirty;
  fifty(
    "forty \\" (, ",
    thirty_x);
  fifty().forty_name_x(  // NOLINT(whitespace/line_length)
    thirty_x);
  fifty(
    thirty,
    {forty, thirty},
    [](int a) {x;});
  std::map<std::vector<
    fifty>, forty> call(  // NOLINT(whitespace/line_length)
    thirty);
  double fifty(
    int forty,
    thirty) const
  {
    return 1;
  }
  // A fifty
  // fifty-forty
  x =
    fifty::forty::
    thirty;
"""


def long(text):
    for name, length in LENGTHS.items():
        text = text.replace(name, name[:2] * (length // 2))
    return text


@pytest.mark.parametrize(
    ("fold", "text", "folded"), [(fold_python, PYTHON, FOLDED_PYTHON), (fit, CPP, FOLDED_CPP)]
)
def test_long_lines(fold, text, folded):
    assert fold(long(text)) == long(folded)
    assert fold(text.replace("[\n    ]", "[]")) == text.replace("[\n    ]", "[]")


LONG = "  # noqa: E501"
JUST = [
    ('"""Words, %s."""', '"""Words, %s."""', '"""Words."""'),
    (*['"""\nWords.\n\nMore %s\n"""'] * 2, '"""\nWords.\n\nMore\n%s\n"""'),
    ("    # Words %s", "    # Words %s", "    # Words\n    # %s"),
    ("call(%s, 2)", "call(\n    %s, 2\n)", "call(\n    %s,\n    2,\n)"),
    ("return %s[1, 2]", "return %s[\n    1, 2\n]", f"return %s[{LONG}\n    1, 2\n]"),
    ("x = [%s]", "x = [\n    %s,\n]", f"x = [\n    %s,{LONG}\n]"),
    ("x = [y(1, 2), %s]", *(f"x = [\n    y(1, 2),\n    %s,{end}\n]" for end in ("", LONG))),
    (
        f"x: Sequence[{'y' * 90}] = (\n    %s,\n)",
        f"x: Sequence[\n    {'y' * 90}\n] = (%s,)",
        f"x: Sequence[\n    {'y' * 90}\n] = (\n    %s,\n)",
    ),
    ("name_name = %s.y", "name_name = (\n    %s.y\n)", f"name_name = %s.y{LONG}"),
    ("name_name = %s.y,", "name_name = (\n    %s.y,\n)", f"name_name = %s.y,{LONG}"),
    ("%s = x.yyyyyy", "%s = (\n    x.yyyyyy\n)", f"%s = x.yyyyyy{LONG}"),
    ("%s = call(2222)", "%s = (\n    call(2222)\n)", f"%s = call({LONG}\n    2222\n)"),
    (
        "x: Sequence[%s] = (\n    1,\n)",
        "x: Sequence[\n    %s\n] = (1,)",
        f"x: Sequence[\n    %s{LONG}\n] = (1,)",
    ),
    (
        "def call(self, %s):\n    pass",
        "def call(\n    self, %s\n):\n    pass",
        "def call(\n    self,\n    %s,\n):\n    pass",
    ),
    (
        "call(\n    namename=%s.y,\n)",
        "call(\n    namename=(\n        %s.y\n    ),\n)",
        f"call(\n    namename=%s.y,{LONG}\n)",
    ),
    (
        "call(\n    %s + summand_summand,\n)",
        "call(\n    %s\n    + summand_summand,\n)",
        f"call(\n    %s{LONG}\n    + summand_summand,\n)",
    ),
]
"""Code, and what becomes of it where the line with `%s` has 99 columns then, and where 100."""


@pytest.mark.parametrize(("code", "fits", "is_long"), JUST)
def test_line_that_just_fits(code, fits, is_long):
    (line,) = (line for line in fits.split("\n") if "%s" in line)
    rest = f"\n# Words\n# {'x' * 100}"
    for length, folded in ((99, fits), (100, is_long)):
        word = "x" * (length - len(line % ""))
        text = code.replace("%s", word) + rest.replace("\n# x", " x")
        assert fold_python(text).replace(rest, "").replace(word, "%s") == folded


NOLINT = "  // NOLINT(whitespace/line_length)"
BROKEN = {
    "// Words %s": "// Words\n// %s",
    "  #define %s 1": f"  #define %s 1{NOLINT}",
    "std::string %s;": "std::string\n  %s;",
    "int f(int a) {return %s;}": "int f(int a)\n{\n  return %s;\n}",
    "using Name = std::vector<%s>;": "using Name =\n  std::vector<%s>;",
    "class Name : public %s": "class Name\n  : public %s",
    '  run(one, "%s", f(2, 3));': '  run(\n    one,\n    "%s",\n    f(2, 3));',
    "return a::%s;": "return a::\n%s;",
    "[[maybe_unused]] int %s;": "[[maybe_unused]]\nint %s;",
    "if (a == %s) {": "if (\n  a ==\n  %s)\n{",
    ": one, %s": ": one,\n%s",
    "const a::B & %s(": "const a::B &\n%s(",
    "std::map<a, std::vector<%s>> b;": "std::map<a, std::vector<\n    %s>> b;",
}
JUST_IN_CPP = [(code, code, broken) for code, broken in BROKEN.items()] + [
    ("std::string %s = 1;", "std::string\n  %s = 1;", "std::string\n  %s =\n  1;"),
    ("std::string %s = 1;", "std::string\n  %s =\n  1;", "std::string\n  %s\n  =\n  1;"),
    ("std::vector<a> %s = 1;", "std::vector<a>\n%s = 1;", "std::vector<a>\n%s =\n1;"),
    ("std::vector<a> %s = 1;", "std::vector<a>\n%s =\n1;", "std::vector<a>\n%s\n  =\n  1;"),
    ("using %s = int;", "using %s =\n  int;", "using %s\n  =\n  int;"),
    ("using %s = int;", "using\n%s\n  =\n  int;", f"using\n%s{NOLINT}\n  =\n  int;"),
    ("const Name & %s;", "const Name &\n%s;", f"const Name &\n%s;{NOLINT}"),
    ("const %s & name;", "const %s &\nname;", "const %s\n& name;"),
    ("const %s & name;", "const %s\n& name;", "const\n%s\n& name;"),
    ('x = "%s";', 'x =\n  "%s";', f'x =\n  "%s";{NOLINT}'),
    ("#define %s", "#define %s", "// *INDENT-OFF*\n#define %s\n// *INDENT-ON*"),
]
"""Code, and what becomes of it where the line with `%s` has 100 columns then, and where 101."""


@pytest.mark.parametrize(("code", "fits", "is_long"), JUST_IN_CPP)
def test_line_of_cpp_that_just_fits(code, fits, is_long):
    (line,) = (line for line in fits.split("\n") if "%s" in line)
    for length, broken in ((100, fits), (101, is_long)):
        word = "x" * (length - len(line % ""))
        assert fit(code % word).replace(word, "%s") == broken


@pytest.mark.parametrize(("before", "margin"), [("x =", ""), ("x", "  "), (" = x", "  ")])
def test_arguments_of_a_value_that_has_its_own_line_begin_where_it_does(before, margin):
    call, arguments = "    create<fifty>(", ["fifty,", "1);"]
    folded = "".join(f"\n    {margin}{argument}" for argument in arguments)
    assert fit(long(f"{before}\n{call}{' '.join(arguments)}")) == long(f"{before}\n{call}{folded}")


def test_comments_of_cpp():
    assert cpp_comment("// TODO: a\\\nNOLINTNEXTLINE(x) ??/") == (
        "// todo: a\\.\nnolintNEXTLINE(x) ??/."
    )
    assert cpp_comment("a // TODO, NOLINT\n") == "a // TODO, NOLINT\n"


@pytest.mark.parametrize(
    ("value", "indent", "used", "literal"),
    [
        ('it\'s "a"', 0, 0, "'it\\'s \"a\"'"),
        ("it's", 0, 0, '"it\'s"'),
        ("\\'", 0, 0, '"\\\\\'"'),
        ("x" * 91, 4, 2, f"'{'x' * 91}'"),
        ("x" * 92, 4, 2, f"(\n        '{'x' * 89}'\n        'xxx'\n    )"),
        ("日" * 50, 4, 0, f"(\n        '{'日' * 44}'\n        '{'日' * 6}'\n    )"),
        ("ab " * 33, 0, 0, f"(\n    '{'ab ' * 30}ab'\n    ' ab ab '\n)"),
        ([1, 2.5e20], 4, 0, "(1, 2.5e20)"),
        (["a"], 4, 0, "('a',)"),
        ([], 4, 0, "()"),
        (["a" * 50, "b" * 60], 4, 10, f"(\n        '{'a' * 50}',\n        '{'b' * 60}',\n    )"),
        (["a" * 40, "b" * 40], 4, 6, f"('{'a' * 40}', '{'b' * 40}')"),
        (["a" * 40, "b" * 40], 4, 8, f"(\n        '{'a' * 40}',\n        '{'b' * 40}',\n    )"),
    ],
)
def test_literals_of_python(value, indent, used, literal):
    assert python_value(value, indent, used) == literal
    assert isinstance(value, list) or python_text(value, indent, used) == literal


def test_literal_of_a_cfg_file():
    assert cfg_value("x" * 92) == f"'{'x' * 92}'"
    assert cfg_value("x" * 93) == f"(\n        '{'x' * 89}'\n        'xxxx'\n    )"


@pytest.mark.parametrize(
    ("given", "others"),
    [
        (("int", 3, 1, 10), [1, 10]),
        (("int", 3), [0, 1, 3 - 10**6, 3 + 10**6]),
        (("int",), [1, -(10**6), 10**6]),
        (("double", 0.5, 0.0), [0.0, 1.0, 1000000.5]),
        (("bool", True), [False]),
        (("string", "a", None, None, ["a", "b", "c"]), ["b", "c"]),
        (("string",), ["other", "another"]),
        (("int[]", [1, 5]), [[0]]),
        (("int[]",), [[1]]),
        (("int", 2**62), [0, 1]),
        (("int", 10**18), [0, 1]),
        (("int", None, 5, 5), [5]),
        (("int", 5, 5, 5), []),
        (("double", 0.0, -1.0, 1.0), [-1.0, 1.0]),
    ],
)
def test_other_values(given, others):
    assert other_values(*given) == others
    assert [type(value) for value in other_values(*given)] == [type(value) for value in others]


@pytest.mark.parametrize(
    ("given", "refused"),
    [
        (("int", 1, 10), [True, 0, 11]),
        (("bool",), ["wrong"]),
        (("bool[]",), ["wrong", ["wrong"]]),
        (("double[]",), [True, [True]]),
        (("string", None, None, ["a"]), [True, "none of them"]),
        (("double", 0.0, 1e6), [True, -1e-4, 1000100.0]),
        (("int", -(2**63), 2**63 - 1), [True]),
        (("int", 0, 2**63 - 2), [True, -1, 2**63 - 1]),
        (("int", None, None, [1, 4]), [True, 5]),
    ],
)
def test_refused_values(given, refused):
    assert refused_values(*given) == refused


def test_imports():
    names = [f"name_{number}" for number in range(20)]
    given = [
        "import b.msg",
        "from typing import Any",
        "import abc",
        "from B import x",
        "import abc",
    ]
    given += ["from a import (\n    b,\n)", f"from x import {', '.join(names)}"]
    given += ["import a", "import abc"]
    folded = "".join(f"    {name},\n" for name in names)
    assert sort_imports("\n".join(given)) == (
        "import abc\nfrom typing import Any\n\n"
        "import a\nfrom a import (\n    b,\n)\nfrom B import x\nimport b.msg\n"
        f"from x import (\n{folded})\n"
    )


LATCHED = {"reliability": "best_effort", "durability": "transient_local", "depth": 1}
SYSTEM = "durability system_default, history system_default"


@pytest.mark.parametrize(
    ("topic", "said", "latched", "queue", "python", "cpp"),
    [
        ({}, "", "", "", "", ""),
        (
            LATCHED,
            "best_effort, transient_local, depth 1",
            "latched, queue 1",
            "queue 1, TCP_NODELAY",
            "QoSProfile(\n        reliability=ReliabilityPolicy.BEST_EFFORT,\n"
            "        durability=DurabilityPolicy.TRANSIENT_LOCAL,\n        depth=1,\n    )",
            "rclcpp::QoS(1).best_effort().transient_local()",
        ),
        (
            {"history": "keep_all"},
            "keep_all",
            "queue without limit",
            "queue without limit",
            "QoSProfile(history=HistoryPolicy.KEEP_ALL)",
            "rclcpp::QoS(rclcpp::KeepAll())",
        ),
        (
            {"qos": "sensor_data"},
            "best_effort, depth 5",
            "queue 5",
            "queue 5, TCP_NODELAY",
            "QoSProfile(reliability=ReliabilityPolicy.BEST_EFFORT, depth=5)",
            "rclcpp::SensorDataQoS()",
        ),
        (
            {"qos": "system_default"},
            f"reliability system_default, {SYSTEM}",
            "",
            "",
            "QoSProfile(\n        reliability=ReliabilityPolicy.SYSTEM_DEFAULT,\n"
            "        durability=DurabilityPolicy.SYSTEM_DEFAULT,\n"
            "        history=HistoryPolicy.SYSTEM_DEFAULT,\n        depth=0,\n    )",
            "rclcpp::SystemDefaultsQoS()",
        ),
    ],
)
def test_qos(topic, said, latched, queue, python, cpp):
    assert qos_words(topic) == said
    assert qos_words(topic, ros=1) == latched
    assert qos_words(topic, ros=1, publishes=False) == queue
    assert (rclpy_qos(topic, 4), rclcpp_qos(topic, 4)) == (python, cpp)


@pytest.mark.parametrize(
    ("topic", "cpp"),
    [
        (
            {"qos": "best_available"},
            "rclcpp::QoS(10).reliability_best_available().durability_best_available()",
        ),
        (
            {"qos": "system_default", "reliability": "reliable", "durability": "volatile"},
            "rclcpp::SystemDefaultsQoS().reliable().durability_volatile()",
        ),
        (
            {"qos": "system_default", "depth": 3},
            "rclcpp::QoS(3).reliability(rclcpp::ReliabilityPolicy::SystemDefault)"
            ".durability(rclcpp::DurabilityPolicy::SystemDefault)"
            ".history(rclcpp::HistoryPolicy::SystemDefault)",
        ),
        (
            {"qos": "system_default", "history": "keep_last"},
            "rclcpp::QoS(10).reliability(rclcpp::ReliabilityPolicy::SystemDefault)"
            ".durability(rclcpp::DurabilityPolicy::SystemDefault)",
        ),
        ({"qos": "sensor_data", "reliability": "reliable"}, "rclcpp::QoS(5)"),
        ({"history": "keep_all", "depth": 3}, "rclcpp::QoS(rclcpp::KeepAll())"),
    ],
)
def test_qos_of_cpp(topic, cpp):
    assert "".join(rclcpp_qos(topic, 4).split()) == cpp


def test_qos_that_is_too_long_for_its_line():
    assert rclcpp_qos(LATCHED, 52).count("\n") == 0
    assert rclcpp_qos(LATCHED, 53) == (
        "rclcpp::QoS(1)"
        + "".join(f"\n{' ' * 53}.{c}()" for c in ("best_effort", "transient_local"))
    )
    line = rclpy_qos({"depth": 1}, 0)
    assert line == "QoSProfile(depth=1)"
    assert rclpy_qos({"depth": 1}, 98 - len(line)) == line
    assert rclpy_qos({"depth": 1}, 99 - len(line)).count("\n") == 2
    assert sorted(rclpy_qos_names([{}, LATCHED])) == [
        "DurabilityPolicy",
        "QoSProfile",
        "ReliabilityPolicy",
    ]
    assert rclpy_qos_names([{}]) == []


LIVELINESS = {"liveliness": "manual_by_topic"}
OFFERED = {"deadline": 0.5, "lifespan": 2.0, **LIVELINESS, "liveliness_lease_duration": 3.0}


def test_what_a_publisher_offers_besides():
    assert qos_words(OFFERED) == "deadline 0.5 s, lifespan 2 s, manual_by_topic, lease 3 s"
    assert qos_words(OFFERED, ros=1) == rclpy_qos(OFFERED, 4) == rclcpp_qos(OFFERED, 4) == ""
    for ros in (1, 2):  # the subscriber's node watches it
        words = qos_words(OFFERED | {"depth": 1}, ros, publishes=False)
        assert words == f"{'queue' if ros == 1 else 'depth'} 1, deadline 0.5 s"
    assert rclpy_qos(OFFERED, 0, publishes=True) == (
        "QoSProfile(\n    depth=10,\n    deadline=Duration(seconds=0.5),\n"
        "    lifespan=Duration(seconds=2),\n"
        "    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,\n"
        "    liveliness_lease_duration=Duration(seconds=3),\n)"
    )
    assert rclcpp_qos(OFFERED, 0, publishes=True).split("\n") == [
        "rclcpp::QoS(10)",
        ".deadline(rclcpp::Duration::from_seconds(0.5))",
        ".lifespan(rclcpp::Duration::from_seconds(2))",
        ".liveliness(rclcpp::LivelinessPolicy::ManualByTopic)",
        ".liveliness_lease_duration(rclcpp::Duration::from_seconds(3))",
    ]
    assert offering([{}, OFFERED, {"liveliness": "automatic"}]) == [OFFERED]
    assert [offers_times([each]) for each in ({}, LIVELINESS, OFFERED)] == [False, False, True]
    assert offers_times([{}, OFFERED])
    assert sorted(rclpy_qos_names([], [LIVELINESS])) == ["LivelinessPolicy", "QoSProfile"]
    assert rclpy_qos_names([{}], [{"deadline": 0.5}]) == ["QoSProfile"]
    assert rclpy_qos_names([{"depth": 1}]) == ["QoSProfile"]


def test_queue_of_ros1():
    sizes = {"keep_all": 0, "system_default": 10, "keep_last": 10}
    assert {word: queue_size({"history": word}) for word in sizes} == sizes
    assert queue_size({"qos": "system_default"}) == 10
