"""Trains a small network on a dataset and tries it on photographs; see docs/transfer.md."""
