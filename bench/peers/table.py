"""The tasks of tasks.h by iritx and by the libraries that do them too, beside
each other. A library that is not installed is left out."""
import os
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
PEERS = (
    ('SISL', '/usr/include/sisl.h',
     ['-x', 'c', '-std=c11', HERE + '/sisl.c', '-lsisl', '-lm']),
    ('Open CASCADE', '/usr/include/opencascade/GeomAPI_IntSS.hxx',
     ['-x', 'c++', '-isystem', '/usr/include/opencascade', HERE + '/occt.cpp'] +
     ['-lTK' + lib for lib in ('GeomAlgo', 'GeomBase', 'BRep', 'G3d', 'G2d', 'Math')] +
     ['-lTKernel']),
)


def run_peer(header, flags, out):
    """{task: (nanoseconds, answer)}; nothing without the library."""
    compiler = os.environ.get('CXX', 'c++') if 'c++' in flags else os.environ.get('CC', 'cc')
    if not os.path.exists(header):
        return {}
    if subprocess.run([compiler, '-O2'] + flags + ['-o', out], check=False,
                      stderr=subprocess.DEVNULL).returncode != 0:
        return {}
    text = subprocess.run([out], capture_output=True, text=True, check=False).stdout
    rows = [line.split('\t') for line in text.splitlines() if line.count('\t') == 2]
    return {name: (float(ns), answer) for name, ns, answer in rows}


def show(build, own, answers, in_words):
    """own: {name: nanoseconds}; answers: {name: text} of those that peers have."""
    if not answers:
        return
    peers = [(name, run_peer(header, flags, os.path.join(build, 'bench', 'peer_%d' % i)))
             for i, (name, header, flags) in enumerate(PEERS)]
    print('\n%-66s %10s' % ('the same tasks -> answer', 'iritx'), end='')
    for name, _ in peers:
        print(' | %12s %6s  %-12s' % (name, 'ours x', 'answer'), end='')
    print()
    for task, answer in answers.items():
        print('%-66s %10s' % (task + ' -> ' + answer, in_words(own[task])), end='')
        for _, rows in peers:
            ns, other = rows.get(task, (0, '-'))
            times = '%.1f' % (ns / own[task]) if ns else '-'
            print(' | %12s %6s  %-12s' % (in_words(ns) if ns else '-', times, other), end='')
        print(flush=True)
    for name, rows in peers:
        if not rows:
            print('%s is not installed (libsisl-dev, libocct-modeling-algorithms-dev)' % name)
