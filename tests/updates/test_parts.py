"""Which parts a file has: what each is called, its lines, what is inside of it."""

import re

import pytest

from hooks.merge.languages import language

PARTS = {
    "a.py": r'''[header]
#!/usr/bin/env python3
# A header
[comment # A comment]

# A comment
[docstring]

"""Words."""
[from .]
>[name a]
from . import a
[from ..b]
from ..b import (  # mine
>[name c]
    c,
>[name d]
    d as e,
[end]
)
[from .b]
>[name f]
from .b import f
>[name g]
from .b import g as h
[from i]
from i import j, k
[from l]
from l import (
    m)
[import os]
import os
[A =]
A = 1
[(A, B) =]
A, B = 1, 2
[C =]
C: int = 2; D = E = (
    3
)
[F = G = 4]
F = G = 4
[setup(one)]
setup("one", f(2))
[setup(two)]
setup(f(2), "two")
["text"]
"text"
[if A]

# Of the condition
if A:
    # Of x
    x = 1

    # Loose

    y = 2
elif B: y = 1
else:
    y = 2
[try]
try:
>[then]
>>[f()]
    f()
>[except (E, F)]
except (E, F):
>>[g()]
    g()
>[else]
else:
>>[h()]

    h()
>[finally]
finally  :
>>[i()]
    i()
[if A #2]
if A:
>[then]
>>[j()]
    # First
    j()
>[elif B]
elif B:
>>[k()]
    k()
>[else]
else:
>>[l()]
    # Last
    l()
[with open("a") as b, c]
with open("a") as b, \
        c:
>[m()]
    m()
[class One]
class One(Two):
>[docstring]
    """One."""
>[n =]

    n = 1
>[def o]

    @deco
    # Of the decorator
    def o(self):
        pass
>[def p]
    async def p(self): pass
[class Three]
class Three: q = 1
[for r in s: t()]
for r in s:
    t()
[comment # The end]
# The end
''',
    "a.hpp": r"""[header]
// A header
[comment /* A comment * of lines */]

/* A comment
 * of lines */
[#ifndef]

#ifndef A__B_HPP_
[#define]
#define A__B_HPP_
[#pragma once]
#pragma once
[#include <vector>]
#include <vector>  // mine
[#include "a/b.hpp"]
#include "a/b.hpp"
[#if defined(C) && \ D]
#if defined(C) && \
  D
>[then]
>>[#include "c.hpp"]
# include "c.hpp"
>[#elif E]
#elif E
>>[variable e]
int e = 1;
>[#else]
#else
[end]
#endif  // why
[#define MAX(a, b) \ ((a) > (b))]

#define MAX(a, b) \
  ((a) > (b))
[namespace a :: b]

namespace a::b { namespace c
{
>[class D]
// Of d
class A_API D final : public E<int, 2>, private F
{
>>[public:]
public:
>>[D()]
  D() = default;
>>[D() #2]
  explicit D(int a) : a_{a}, b_(2) {}
>>[~D()]
  ~D() override;
>>[comment // Loose]

  // Loose
>>[get()]

  template<class T, int N = (1 > 2)>
  std::vector<T> get(const std::array<T, N> & all = {}) const noexcept
  {
    return {all};
  }
>>[operator==()]
  bool operator==(const D & other) const;
>>[operatorbool()]
  operator bool() const {return a_;}
>>[after()]
  A_MACRO(one)
  void after();
>>[A_ALONE]
  A_ALONE
>>[private:]

private  :
>>[variable a_]
  int a_{1}, b_ = 2;
>>[struct G]
  struct G {int h;} g_;
>>[class I]
  enum class I { j, k };
>>[using L]
  using L = std::function<void(int)>;
>>[class M]
  friend class M;
>[end]
};
>[extern "C"]
extern "C" {
>>[n()]
void n(void);
>[end]
}
>[extern int o]
extern int o;
>[variable q]
static const char * q[] = {"{", "}"};
>[variable r]
auto r = [](int s) { return s; };
>[t()]
[[nodiscard]] inline int t();  int u;
>[struct V]
struct V;
>[Y::z()]
int X::Y::z(int) &&
{
}
[end]
}}  // namespace c
[#if 0]
#if 0
>[then]
>>[header]
void { (
[end]
#endif
[variable last]
int last =
#ifdef A
  1;
#else
  2;
#endif
[A_END ( 1 )]
A_END(1)
[#endif]
#endif  // A__B_HPP_
""",
    "CMakeLists.txt": r"""[header]
# A header
[project arm]

Project(arm)
[set A]
set(A 1) set(B 2)
[set A #2]
set(A
  3)
[if(A AND B)]
IF(A AND B)  # why
>[then]
>>[x a]
  # Of x
  x(a)
>[elseif (C)]
elseif (C)
>[else]
else()
>>[y]
  y()
[end]
endif()
[foreach a]

foreach(a b)
>[then]
>>[z ${a}]
  z(${a})
>>[while c]
  while(c)
>>>[then]
>>[end]
  endwhile()
[end]
endforeach()
[macro own]
macro(own a)
>[then]
[end]
endmacro()
[function other]
function(other)
>[then]
[end]
endfunction()
[block]
block()
>[then]
[end]
endblock()
[catkin_package]
#[[ A comment

of lines ]]
catkin_package(
  INCLUDE_DIRS a
)
[ament_export_libraries]
ament_export_libraries(b)
[q]
q()
""",
    "a.yaml": r"""[header]
# A header
[a]

# Of a
a: 1  # one
[b]
b:
>[c]
  # Of c
  c: [1,
      2]
>[comment # Loose]

  # Loose
>[d]

  d: |
    # no

    x: y
>[e]
  "e": {f: 1}
>[comment # Behind]
  # Behind
[g]
g:
>[- h]
- h
>[- i: 1]
- i: 1
>>[j]
  j: 2
[k]
# Of k
k:
>[- - l]
  - - l
>>[- m]
    - m
  -
>[n: 1]
    n: 1
>[- "o p"]
  - "o p"
[q]
? q
: r
[s]

s: &t
>[u]
  u: 1
[v]
v: *t
[w]
w: !!str >-
  x
[a #2]

---
a: 2
""",
    "a.launch": r"""[header]
<?xml version="1.0"?>
<!-- A header -->
[launch]

<launch>
>[arg a]
  <!-- Of a
  arg -->
  <arg name="a" default="b > c"/>
>[comment <!-- Loose -->]
  <!-- Loose -->
>[arg b]

  <arg
    default='1' name='b'/>
>[group $(arg a)]

  <group if="$(arg a)"><node name="c">
    <param name="d"/></node></group>
>[node ]
  <node pkg="e" exec="f" name="">
>>[param g]
    <param name="g"/>
>>[remap h]

    <remap from="h" to="i"></remap>
>[end]
  </node>
>[include j]
  <include file="j"/> <include file="k"/>
>[b]
  <b>  l
  m </b>
>[url n]
  <url type="n">o</url>
>[url o p]
  <url>o  p</url>
>[exec_depend r]
  <exec_depend condition="q"> r </exec_depend>
>[t]
  <![CDATA[ <s> ]]>
  <t/>
[end]
</launch>
""",
    "a.md": r"""[start]
Words.

[# One]
# One
[## Two ##]
## Two ##
<!-- # no
# no -->
<!-- so --> # no
````sh
# no
```
````
[# One #2]
# One
~~~ a
# no
~~~ b
~~~
   # no
#no
####### no
[###### six]
###### six
- ```
  # no
  ```
<!-- a --> <!--
# no
-->
[# Three]
#  Three
""",
    "A.action": r"""[header]
# A header
[0 a]

# Of a
int32 a
[0 b]
string<=5[] b  # c
[0 C]
int32 C=1
[---]

---
>[1 d]
# Of d
float64 d 0.5
[--- #2]
---
""",
}
"""Files in which the name of each part stands above it, after as many `>` as it is deep."""


def named(blocks, depth=0):
    """Yield the lines of parts, the name of each above it."""
    for block in blocks:
        yield f"{'>' * depth}[{block.key}]\n"
        yield from block.lines
        yield from named(block.children, depth + 1)
        yield from [f"{'>' * depth}[end]\n", *block.tail] if block.tail else []


@pytest.mark.parametrize("path", PARTS)
def test_parts_of_a_file(path):
    text = re.sub(r"(?m)^>*\[.*\]\n", "", PARTS[path])
    assert "".join(named(language(path, text).blocks(text))) == PARTS[path]
