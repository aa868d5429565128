"""What is written behind the command: words, paths, streams, help."""

from __future__ import annotations

import errno
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import NoReturn

import pytest

from dhgen.cli import main
from dhgen.robot.source import quoted
from tests.cli.commands import (
    FILES,
    HASTY,
    HASTY_PROGRAM,
    PLANAR,
    ROOT,
    WRONG,
    Run,
    dhgen,
    in_shell,
    names,
)
from tests.structures import first_of


@pytest.mark.parametrize("words", [[""], ["explain", ""], ["survey", ""], ["--out", "", "x"]])
def test_an_empty_text_is_no_path(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(words)
    assert stopped.value.code == 2
    assert "a path can't be empty" in capsys.readouterr().err


def test_a_compiler_that_builds_nothing_is_not_the_file_s_fault(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "broken"
    broken.write_text("#!/bin/sh\necho cannot find ld >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    done = run(PLANAR, folder=tmp_path)
    told = f"the C compiler {broken} can't build anything here:\ncannot find ld\nfix it, or set"
    assert (done.returncode, done.stderr) == (1, f"{told} $CC to another compiler\n")
    assert not (tmp_path / "generated").exists()


def test_without_a_path_the_compiler_finds_its_linker(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PATH")
    monkeypatch.delenv("CC", raising=False)
    done = run(PLANAR, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "Python and C agree" in done.stdout


def test_links_that_lead_in_a_circle(run: Run, tmp_path: Path) -> None:
    (tmp_path / "loop").symlink_to("loop")
    for words in (["loop"], ["--check", "loop"], ["explain", "loop"]):
        done = run(*words, folder=tmp_path)
        told = "loop: the file can't be read: Too many levels of symbolic links\n"
        assert (done.returncode, done.stderr) == (2, told)
    done = run("--check", PLANAR, "--out", "loop", folder=tmp_path)
    assert done.returncode == 1
    assert "loop/planar_rr.c: can't be read (Too many levels of symbolic links)" in done.stderr


@pytest.mark.parametrize("closed", first_of(["<&- >&- 2>&-", "2>&-"]))
def test_streams_that_are_closed_change_nothing_but_what_is_told(
    closed: str, tmp_path: Path
) -> None:
    """As services and cron jobs may start it."""
    (tmp_path / "wrong.yaml").write_text(WRONG)
    done = in_shell(f"explain wrong.yaml {closed}", tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", "")
    done = in_shell(f"explain {PLANAR} {closed}", tmp_path)
    assert (done.returncode, not done.stdout) == ((0, False) if closed == "2>&-" else (2, True))


@pytest.mark.breadth
def test_files_are_written_where_all_streams_are_closed(tmp_path: Path) -> None:
    done = in_shell(f"--out x {PLANAR} <&- >&- 2>&-", tmp_path, HASTY)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert names(tmp_path / "x") == FILES


@pytest.mark.parametrize("verb", ["explain", "survey"])
def test_what_is_only_printed_needs_somewhere_to_print(verb: str, tmp_path: Path) -> None:
    done = in_shell(f"{verb} {PLANAR} >&-", tmp_path)
    told = "dhgen: standard output is closed: there is nothing to print to\n"
    assert (done.returncode, done.stderr) == (2, told)


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("explan", "explain"),
        ("survy", "survey"),
        ("check", "--check"),
        ("version", "--version"),
    ],
)
def test_a_misspelt_verb(word: str, meant: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([word, str(PLANAR)]) == 2
    expected = f"dhgen: no file '{word}'; did you mean 'dhgen {meant}'?\n"
    assert capsys.readouterr() == ("", expected)


def test_no_such_file(tmp_path: Path) -> None:
    done = dhgen("none.yaml", folder=tmp_path)
    assert done.returncode == 2
    assert "none.yaml" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("words", [[], ["--chekc", "a.yaml"], ["explain"]])
def test_a_mistake_on_the_command_line_is_exit_2(words: list[str], tmp_path: Path) -> None:
    done = dhgen(*words, folder=tmp_path)
    assert done.returncode == 2
    assert done.stderr.startswith("usage: dhgen")


def test_a_number_of_poses_that_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    """Of a million millions the joint values alone would fill any memory."""
    for word in ("x", "0", "-3", "1.5", "100001", "1000000000000", "9" * 5000):
        with pytest.raises(SystemExit, match="2"):
            main(["survey", str(PLANAR), "--poses", word])
        wanted = f"--poses: must be a whole number from 1 to 100000, not {quoted(word)}\n"
        assert capsys.readouterr().err.endswith(wanted)
    for word in ("x", "-1", "10000001"):
        with pytest.raises(SystemExit, match="2"):
            main(["survey", str(PLANAR), "--recall", word])
        wanted = f"--recall: must be a whole number from 0 to 10000000, not {quoted(word)}\n"
        assert capsys.readouterr().err.endswith(wanted)


@pytest.mark.parametrize(
    ("option", "told"), [("--help", "exit codes: 0 done"), ("--version", "dhgen ")]
)
def test_help_and_version_need_no_sympy(option: str, told: str, tmp_path: Path) -> None:
    done = dhgen(option, folder=tmp_path, PYTHONPROFILEIMPORTTIME="1")
    assert done.returncode == 0
    assert told in done.stdout
    assert "argparse" in done.stderr
    assert "sympy" not in done.stderr


@pytest.mark.parametrize("option", [[], ["--alternatives"], ["--program"]])
def test_explain(run: Run, option: list[str], tmp_path: Path) -> None:
    done = run("explain", PLANAR, *option, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert {"θ₂", "theta2"} & set(re.split(r"[\s:,;.$]", done.stdout))
    assert names(tmp_path) == []


def test_explain_in_french(run: Run, tmp_path: Path) -> None:
    done = run("explain", PLANAR, "--language", "fr", folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "Modèle géométrique inverse\n----" in done.stdout
    assert "Toutes les solutions\u00a0:\n" in done.stdout


def test_explain_says_first_that_a_task_asks_for_too_much(run: Run, tmp_path: Path) -> None:
    """In the derivation this stands far below, where the pose is checked."""
    text = PLANAR.read_text(encoding="utf-8").replace("task: [x, y]\n", "")
    (tmp_path / "arm.yaml").write_text(text, encoding="utf-8")
    done = run("explain", "arm.yaml", folder=tmp_path)
    assert done.returncode == 0
    checked = "note: every pose is checked: the task asks for more than the arm can choose\n"
    assert done.stderr == f"{checked}note: `task: [x, y]` would ask for as much as it can\n"


@pytest.mark.parametrize(
    ("wished", "begins", "file"),
    [
        ("latex", "% planar", "my.tex"),
        ("html", "<!DOCTYPE html>", "my.HTML"),
        ("markdown", "<!-- planar", "my.md"),
        ("text", "", "my.txt"),
    ],
)
def test_explain_writes_a_handout(
    wished: str, begins: str, file: str, run: Run, tmp_path: Path
) -> None:
    """In the format that is said, or that the ending of its file says."""
    printed = run("explain", PLANAR, "--format", wished, folder=tmp_path)
    assert (printed.returncode, printed.stderr) == (0, "")
    assert printed.stdout.startswith(begins)
    assert names(tmp_path) == []
    done = run("explain", PLANAR, "--out", f"new/{file}", folder=tmp_path)
    assert (done.returncode, done.stdout) == (0, f"wrote new/{file}\n")
    assert (tmp_path / "new" / file).read_text(encoding="utf-8") == printed.stdout
    linked = set(re.findall(r"\]\((figures/\w+\.svg)\)", printed.stdout))
    beside = {str(path.relative_to(tmp_path / "new")) for path in tmp_path.rglob("*.svg")}
    assert beside == linked
    assert bool(linked) == (wished == "markdown")


def test_explain_says_that_it_writes_over_a_file(run: Run, tmp_path: Path) -> None:
    (tmp_path / "notes.md").write_text("what somebody else wrote\n", encoding="utf-8")
    first = run("explain", PLANAR, "--out", "notes.md", folder=tmp_path)
    assert first.stderr == "note: notes.md was there and is written over\n"
    again = run("explain", PLANAR, "--out", "notes.md", folder=tmp_path)
    assert (again.returncode, again.stderr) == (0, "")


def test_explain_does_not_write_over_what_it_reads(run: Run, tmp_path: Path) -> None:
    text = Path(PLANAR).read_text("utf-8")
    (tmp_path / "own.yaml").write_text(text, encoding="utf-8")
    done = run("explain", "own.yaml", "--out", "own.yaml", folder=tmp_path)
    assert done.returncode == 2
    assert "own.yaml is what was read: write to another file" in done.stderr
    assert (tmp_path / "own.yaml").read_text("utf-8") == text


def test_explain_says_what_does_not_go_together(run: Run, tmp_path: Path) -> None:
    done = run("explain", PLANAR, "--format", "html", "--program", folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "dhgen: --program is printed as text alone, not with --format\n"
    done = run("explain", PLANAR, "--language", "fr", "--alternatives", folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    told = "dhgen: --alternatives is printed in English alone, not with --language\n"
    assert done.stderr == told
    done = run("explain", PLANAR, "--out", ".", folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "dhgen: can't write .: it is a folder\n"


def test_explain_refuses_endings_of_no_format(run: Run, tmp_path: Path) -> None:
    done = run("explain", PLANAR, "--out", "x.docx", folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    endings = ".txt, .md, .tex, .html or .htm"
    told = f"dhgen: x.docx: no format has the ending .docx: write to {endings}, or say --format\n"
    assert done.stderr == told
    done = run("explain", PLANAR, "--format", "markdown", "--out", "x.docx", folder=tmp_path)
    assert done.returncode == 0
    done = run("explain", PLANAR, "--format", "html", "--out", "x.tex", folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    told = "dhgen: x.tex: the ending .tex is that of latex, not of --format html\n"
    assert done.stderr == told
    assert not (tmp_path / "x.tex").exists()


@pytest.mark.parametrize("file", ["x.docx", "x.HTML", "x.tex"])
def test_explain_refuses_endings_of_no_text_for_a_program(
    run: Run, tmp_path: Path, file: str
) -> None:
    done = run("explain", PLANAR, "--program", "--out", file, folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        f"dhgen: {file}: --program is printed as text alone: write to .txt, or say --format text\n"
    )
    words = ("--program", "--format", "text", "--out", file)
    assert run("explain", PLANAR, *words, folder=tmp_path).returncode == 0


def test_html_without_its_package(tmp_path: Path) -> None:
    """A folder of that name that is no package stands for none."""
    (tmp_path / "latex2mathml.py").write_text("raise ModuleNotFoundError", encoding="utf-8")
    path = os.pathsep.join((str(tmp_path), str(ROOT)))
    done = dhgen("explain", str(PLANAR), "--format", "html", folder=tmp_path, PYTHONPATH=path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "dhgen: HTML needs latex2mathml: pip install 'dhgen[html]'\n"


@pytest.mark.parametrize(
    ("words", "reader", "passes"),
    [
        (f"explain {PLANAR}", "true", True),
        ("broken.yaml", "true", False),
        *first_of(
            [
                (f"explain {PLANAR}", "head -1", True),
                (f"--check --out . {PLANAR}", "head -1", False),
            ],
            count=0,
        ),
    ],
)
def test_a_reader_who_has_seen_enough(
    words: str, reader: str, *, passes: bool, tmp_path: Path
) -> None:
    """`dhgen --check x.yaml 2>&1 | head -1` does not pass for that."""
    (tmp_path / "broken.yaml").write_text("name: 3\n", encoding="utf-8")
    command = f"{sys.executable} -m dhgen {words} 2>&1 | {reader}; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(
        ["/bin/bash", "-c", command],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert "Traceback" not in done.stdout + done.stderr
    assert (done.stdout.split()[-1] == "0") is passes


# One worker that waits for work and one that has some; a call out of C, which forgets errors.
AT_WORK = """
import ctypes, multiprocessing.util, os, signal, sys, tempfile, time
from dhgen import cli
from dhgen.workers import side_by_side

def work(seconds):
    with tempfile.TemporaryDirectory():
        os.write(1, b"at work\\n")  # at once: others write, too
        time.sleep(seconds)

def work_twice(_):
    return len(list(side_by_side(work, [0, 60])))

def work_before_the_other_has_begun(_):
    def begin(_):
        try:
            time.sleep(0.5 if multiprocessing.current_process().name.endswith("-2") else 0)
        except KeyboardInterrupt:
            os.write(2, b"a beginning that is interrupted\\n")
    multiprocessing.util.register_after_fork(begin, begin)
    return work_twice(_)

def work_for_c(_):
    ctypes.CFUNCTYPE(None)(lambda: work(60))()
    for _ in range(600):
        time.sleep(0.1)

def fail_for_c(_):
    ctypes.CFUNCTYPE(None)(lambda: work(60))()
    raise RuntimeError("what was called has not done what it should")

signal.signal(signal.SIGINT, signal.default_int_handler)  # what is in the background ignores it
cli._run = {work}
sys.exit(cli.main([]))
"""


@pytest.mark.parametrize(
    ("work", "reaches"),
    [
        ("work_twice", "all"),
        ("work_twice", "the first"),
        ("work_before_the_other_has_begun", "all"),
        ("work_for_c", "the first"),
        ("fail_for_c", "the first"),
    ],
)
def test_an_interrupt_ends_everything_without_a_word(
    work: str, reaches: str, tmp_path: Path
) -> None:
    """Ctrl-C reaches all processes of a command, `kill -INT` one."""
    process = subprocess.Popen(
        [sys.executable, "-c", AT_WORK.replace("{work}", work)],
        env=os.environ | {"PYTHONPATH": str(ROOT), "TMPDIR": str(tmp_path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stdout is not None
    started = 1 if "for_c" in work else 2
    assert [process.stdout.readline() for _ in range(started)] == ["at work\n"] * started
    (os.killpg if reaches == "all" else os.kill)(process.pid, signal.SIGINT)
    told = process.communicate(timeout=30)
    assert (told[1], process.returncode) == ("dhgen: interrupted\n", 130)
    assert list(tmp_path.iterdir()) == []


COMPILER = """\
#!/bin/sh
echo half a file > "${TMPDIR:-/tmp}/cc123.s"
echo at work > "$AT_WORK"
exec sleep 60
"""

# what is in the background ignores it
HEEDFUL = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
"""


def test_an_interrupt_leaves_nothing_of_the_compiler(tmp_path: Path) -> None:
    """As of gcc, which is stopped amid its work, and then removes no passing files of its own.

    Ctrl-C goes to all processes of a terminal's group.
    """
    slow, at_work, passing = tmp_path / "slow", tmp_path / "at work", tmp_path / "passing"
    slow.write_text(COMPILER)
    slow.chmod(0o755)
    passing.mkdir()
    own = {"CC": str(slow), "AT_WORK": str(at_work), "TMPDIR": str(passing)}
    process = subprocess.Popen(
        [sys.executable, "-c", HEEDFUL + HASTY_PROGRAM, str(PLANAR), "--out", str(tmp_path / "x")],
        env=os.environ | {"PYTHONPATH": str(ROOT), "NUMBA_DISABLE_JIT": "1"} | own,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    for _ in range(600):
        if at_work.exists() or process.poll() is not None:
            break
        time.sleep(0.1)
    os.killpg(process.pid, signal.SIGINT)
    told = process.communicate(timeout=30)[1]
    assert (told, process.returncode) == ("dhgen: interrupted\n", 130)
    assert at_work.exists()
    assert list(passing.iterdir()) == []


def test_workers_end_with_a_command_that_is_killed(tmp_path: Path) -> None:
    """Standard output has an end when nobody holds it any more."""
    process = subprocess.Popen(
        [sys.executable, "-c", AT_WORK.replace("{work}", "work_twice")],
        env=os.environ | {"PYTHONPATH": str(ROOT), "TMPDIR": str(tmp_path)},
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    assert [process.stdout.readline() for _ in range(2)] == ["at work\n"] * 2
    process.kill()
    assert process.communicate(timeout=30)[0] == ""
    assert list(tmp_path.iterdir()) == []


SAID = """
import signal, sys, time
from dhgen import cli

def say(_):
    print("what nobody will read")
    print("said", file=sys.stderr, flush=True)
    time.sleep(60)

signal.signal(signal.SIGINT, signal.default_int_handler)  # what is in the background ignores it
cli._run = say
sys.exit(cli.main([]))
"""


def test_an_interrupt_that_ends_the_reader_too() -> None:
    """As of `dhgen x.yaml | head`: what is left to be written has nowhere to go."""
    with subprocess.Popen(
        [sys.executable, "-c", SAID],
        env=os.environ | {"PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": ""},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.readline() == "said\n"
        process.send_signal(signal.SIGINT)
        assert process.stderr.read() == "dhgen: interrupted\n"
    assert process.returncode == 130


def test_a_full_disk_behind_what_is_said(tmp_path: Path) -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("no device that is full")
    (tmp_path / "wrong.yaml").write_text(WRONG)
    told = f"dhgen: {os.strerror(errno.ENOSPC)}: output\n"
    done = in_shell(f"explain {PLANAR} >{full}", tmp_path)
    assert (done.returncode, done.stderr) == (1, told)
    done = in_shell(f"explain wrong.yaml 2>{full}", tmp_path)
    assert (done.returncode, done.stdout) == (2, "")


@pytest.mark.parametrize("verb", ["write", "check", "explain", "survey"])
def test_an_interrupt_is_one_line(
    verb: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(_: object) -> NoReturn:
        print("a line")  # noqa: T201
        raise KeyboardInterrupt

    monkeypatch.setattr(f"dhgen.cli.{verb}", interrupted)
    words = {"write": [], "check": ["--check"]}.get(verb, [verb])
    assert main([*words, str(PLANAR)]) == 130
    assert capsys.readouterr() == ("a line\n", "dhgen: interrupted\n")
