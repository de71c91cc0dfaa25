"""A topic becomes several, and one again: the code of its callback stays."""

import pytest

from support.repository import commit, git

SPEC = """<package name="arm" author="A" author_email="a@example.org"
         description="D" license="MIT">
  <node name="reach">
    <directPublisher name="out" type="std_msgs::String"/>
    <directSubscriber name="say" type="std_msgs::String"/>
    <directSubscriber name="hear" type="std_msgs::String"/>
    <parameter name="topics" type="string[]" value="[a, b]"/>
  </node>
</package>
"""
CODE = {
    "python_model": "        self.passthrough.log.info(message.data)\n",
    "cpp_model": "  passthrough_.log.info(message.data);\n",
}
LOGIC = {"python_model": "arm/reach_impl.py", "cpp_model": "src/reach_impl.cpp"}


def body(text, method):
    """Return where the body of a method begins."""
    sign = '"""\n' if '"""' in text else "{\n"
    start = text.index(f"receive_{method}(")
    start = text.index('"""', start) + 3 if '"""' in text else start
    return text.index(sign, start) + len(sign)


@pytest.mark.parametrize("model", LOGIC)
def test_there_and_back(render, update, model):
    package = render(SPEC, model=model, name="arm")
    impl, spec = package / LOGIC[model], package / "arm.ros_package"
    text = impl.read_text()
    for method in ("say", "hear"):
        at = body(text, method)
        text = text[:at] + CODE[model] + text[at:]
    impl.write_text(text)
    commit(package, "Write the logic")
    spec.write_text(SPEC.replace('name="say"', 'name="say" for_each="topics"'))
    commit(package, "Say it on several topics")
    update(package)
    git(package, "diff", "--check")
    after = impl.read_text()
    assert after.count(CODE[model]) == 2
    signature = after[after.index("receive_say(") : body(after, "say")]
    assert "topic" in signature
    assert after[body(after, "say") :].startswith(CODE[model])
    assert "topic" not in after[after.index("receive_hear(") : body(after, "hear")]
    commit(package, "Update")
    spec.write_text(SPEC)
    commit(package, "Say it on one topic")
    update(package)
    assert impl.read_text() == text
