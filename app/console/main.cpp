// fyd-console: the operator's window. Exit codes: 0 success, 1 the session could not be opened, 2 wrong usage.
int main() { return 0; }
