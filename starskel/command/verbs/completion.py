"""starskel completion: the script that lets a shell complete the command's words."""

from argparse import Namespace

from argcomplete.shell_integration import shellcode


def run(arguments: Namespace) -> int:
    """Print the script for a shell."""
    print(shellcode(["starskel"], shell=arguments.shell))
    return 0
