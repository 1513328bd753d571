"""What the test runners share: running programs with bounds, reporting.

A runner makes a Report, tells it the outcome of each test, and ends with
report.finish(), which prints "NAME: N passed, N failed, N skipped (T s)"."""
import concurrent.futures
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OUTPUT_LIMIT = 1 << 26  # bytes of output kept; more is a defect by itself


class Result:
    """How a program ended. status is as in a shell: 128 + n for signal n."""

    def __init__(self, status, out, err, seconds, peak, timed_out):
        self.status, self.out, self.err = status, out, err
        self.seconds, self.peak, self.timed_out = seconds, peak, timed_out

    def how(self):
        if self.timed_out:
            return 'timeout after %.0f s' % self.seconds
        if self.status > 128:
            return 'killed by ' + signal.Signals(self.status - 128).name
        return 'exit status %d' % self.status


def is_sanitized(path):
    """Told by the build directory: build/asan/..., build/hard-clang/..."""
    parts = path.split(os.sep)
    return any(p.split('-')[0] in ('asan', 'hard') for p in parts)


def environment(**extra):
    """The caller's, without what would change output, with strict sanitizers."""
    env = {k: v for k, v in os.environ.items()
           if not k.startswith(('LC_', 'LANG', 'IRITX_', 'IRIT_'))}
    env['ASAN_OPTIONS'] = 'detect_leaks=1:allocator_may_return_null=1:exitcode=99'
    env['UBSAN_OPTIONS'] = 'print_stacktrace=1:exitcode=99'
    env['LSAN_OPTIONS'] = ('exitcode=99:print_suppressions=0:suppressions=' +
                          os.path.join(os.path.dirname(os.path.abspath(__file__)), 'lsan.supp'))
    env.update(extra)
    return env


def run(cmd, timeout, cwd=None, env=None, stdin=b'', scale=True):
    """Runs cmd to its end; kills it and its children after timeout seconds
    (ten times that for a sanitized program, unless scale is False)."""
    if scale and is_sanitized(cmd[0]):
        timeout *= 10
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, \
            tempfile.TemporaryFile() as inp:
        inp.write(stdin)
        inp.seek(0)
        start = time.monotonic()
        proc = subprocess.Popen(cmd, cwd=cwd, env=env or environment(), stdin=inp, stdout=out,
                                stderr=err, start_new_session=True)
        late = threading.Event()

        def stop():
            late.set()
            os.killpg(proc.pid, signal.SIGKILL)

        timer = threading.Timer(timeout, stop)
        timer.start()
        _, status, usage = os.wait4(proc.pid, 0)
        timer.cancel()
        seconds = time.monotonic() - start
        proc.returncode = os.waitstatus_to_exitcode(status)
        if proc.returncode < 0:
            proc.returncode = 128 - proc.returncode
        out.seek(0)
        err.seek(0)
        return Result(proc.returncode, out.read(OUTPUT_LIMIT).decode('utf-8', 'replace'),
                      err.read(OUTPUT_LIMIT).decode('utf-8', 'replace'), seconds,
                      usage.ru_maxrss * 1024, late.is_set())


def in_parallel(function, items):
    """function(item) for all items, on all processors; results in order."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        yield from pool.map(function, items)


# What a test returns in place of a problem when the build cannot run it.
LEFT_OUT = 'built without a library that it needs'
NEEDS = {'WITH_SUNDIALS': r'\b(geodesic|geodnrml|geodoffset|medialcrv|srffocalcrv)\s*\(',
         'WITH_CAIRO': r'\bsave\s*\([^;]*\.(svg|png|pdf)"'}


def left_out(text):
    """Does a script need a library that the build has not (WITH_CAIRO=0 ...)?"""
    return any(os.environ.get(option) == '0' and re.search(pattern, text, re.I)
               for option, pattern in NEEDS.items())


class Report:
    def __init__(self, name):
        self.name, self.passed, self.failed = name, 0, 0
        self.skipped, self.start = [], time.monotonic()

    def ok(self, count=1):
        self.passed += count

    def fail(self, test, text='', count=1):
        """One failed test; text is shown below its name."""
        self.failed += count
        print('FAIL  %s: %s' % (self.name, test))
        for line in text.rstrip().splitlines()[:200]:
            print('      ' + line)
        sys.stdout.flush()

    def skip(self, test, reason):
        self.skipped.append((test, reason))

    def result(self, test, problem):
        """Failed with this text, or passed if there is none."""
        if problem is LEFT_OUT:
            self.skip(test, problem)
        elif problem:
            self.fail(test, problem)
        else:
            self.ok()

    def finish(self):
        reasons = {}
        for test, reason in self.skipped:
            reasons.setdefault(reason, []).append(test)
        for reason, tests in reasons.items():
            names = ' '.join(tests[:5]) + (' ...' if len(tests) > 5 else '')
            print('skip  %s: %d (%s): %s' % (self.name, len(tests), names, reason))
        tail = ', %d skipped' % len(self.skipped) if self.skipped else ''
        print('%s: %d passed, %d failed%s (%.1f s)' % (
            self.name, self.passed, self.failed, tail, time.monotonic() - self.start))
        sys.exit(1 if self.failed else 0)


def need_program(path, name):
    """The absolute path of the program; ends the runner if it is not there."""
    if not os.access(path, os.X_OK):
        report = Report(name)
        report.skip('all', 'there is no program %s' % path)
        report.finish()
    return os.path.abspath(path)
