uhas-project-surface --version
